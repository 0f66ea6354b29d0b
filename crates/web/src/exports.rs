//! The protocol of Typst's plugins, which the page speaks, too: the host calls a function with the length of its
//! argument; the function fetches the argument and hands over the result, both through functions of the host.
//!
//! Reference: the documentation of `plugin` in Typst.
#![allow(unsafe_code)]

#[link(wasm_import_module = "typst_env")]
unsafe extern "C" {
    #[link_name = "wasm_minimal_protocol_write_args_to_buffer"]
    safe fn write_arguments(buffer: *mut u8);
    #[link_name = "wasm_minimal_protocol_send_result_to_host"]
    safe fn send_result(bytes: *const u8, length: usize);
}

/// Answers a request of so many bytes; 0 if there is one, else 1, and the result says why.
// Safety: no other symbol of the module has this name.
#[unsafe(no_mangle)]
extern "C" fn answer(length: usize) -> i32 {
    let mut request = vec![0; length];
    write_arguments(request.as_mut_ptr());
    // Only a host that asks for it is told something before the answer.
    let mut tell = |partial: &str| send_result(partial.as_ptr(), partial.len());
    let (status, result) = match std::str::from_utf8(&request) {
        Ok(request) => (0, super::answer_telling(request, &mut tell)),
        Err(_) => (1, "a request is text in UTF-8".to_owned()),
    };
    send_result(result.as_ptr(), result.len());
    status
}
