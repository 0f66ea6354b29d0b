use polarform::latex::read_rows;
fn main() {
    for a in std::env::args().skip(1) {
        println!("== {a}");
        for r in read_rows(&a) {
            println!("lead {:?} {}", r.leading.map(|x| x.0), polarform::write::latex(&r.expr));
            println!("   {}", short(&r.expr));
            for p in r.problems {
                println!("   ! {}", p.message)
            }
        }
    }
}
fn short(e: &polarform::expr::Expr) -> String {
    let s = format!("{:?}", e.clone().without_spans());
    let re = s.replace(", span: 0..0", "").replace("Expr { kind: ", "");
    re.replace(" }", "")
}
