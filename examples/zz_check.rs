use polarform::notes::{
    Options, check_document,
    extract::{Container, document},
};
use polarform::source::SourceFile;
fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let json = args.iter().any(|a| a == "--json");
    let mut files = vec![];
    for a in args.iter().filter(|a| !a.starts_with("--")) {
        let text = std::fs::read_to_string(a).unwrap();
        let start = std::time::Instant::now();
        let doc = document(SourceFile::new(a.clone(), text), Container::Markdown);
        let mut options = Options::default();
        options.limits.time = Some(std::time::Duration::from_secs(5));
        let report = check_document(&doc, &options);
        let mut list = vec![];
        for f in &report.findings {
            let (line, col) = report.file.line_column(f.span.start);
            let (end, _) = report.file.line_column(f.span.end.max(f.span.start + 1) - 1);
            if json {
                list.push(serde_json::json!({"line":line,"column":col,"end_line":end,"latex":f.latex,"relation":f.relation,"verdict":f.verdict.word(),"reason":f.reason,"witness":f.witness,"suggestion":f.suggestion,"warning":f.warning}));
            } else if f.relation > 0 {
                println!(
                    "{line}:{col} [{}] {} {}\n      {}{}{}{}{}",
                    f.relation,
                    f.verdict.word().to_uppercase(),
                    f.latex.replace('\n', " ").chars().take(150).collect::<String>(),
                    f.reason.clone().unwrap_or_default(),
                    f.witness.as_ref().map(|w| format!("\n      WIT {w}")).unwrap_or_default(),
                    f.instances.as_ref().map(|w| format!("\n      INST {w}")).unwrap_or_default(),
                    f.suggestion.as_ref().map(|w| format!("\n      SUG {w}")).unwrap_or_default(),
                    f.warning.as_ref().map(|w| format!("\n      WARN {w}")).unwrap_or_default()
                );
            }
        }
        if !json {
            println!("## {a} {:?}", start.elapsed());
        }
        files.push(serde_json::json!({"file":a,"formulas":list}));
    }
    if json {
        println!("{}", serde_json::json!({"files":files,"summary":{}}));
    }
}
