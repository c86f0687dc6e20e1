//! Apps of Gradio: a function of theirs that makes a model of a description, called over HTTP.
//!
//! The app is asked which inputs the function has (`info`). The first that takes a text gets the description, and the others
//! their defaults. A call (`call/FUNCTION`) answers with the ID of an event, whose result is a stream of server-sent events.
//! The first GLB file in the result is the model. Version 4 of Gradio has these addresses at the root, later versions have
//! them below `gradio_api`.

use super::Watch;
use super::service::{id, json_of, told};
use scenelang_llm::{Error, Web, plain};
use serde_json::{Value, json};

/// Where the addresses may be.
const ROOTS: [&str; 2] = ["/gradio_api", ""];

/// Makes a GLB file with a function of the app at `base`.
///
/// # Errors
/// Why there is none, in words.
pub(super) fn make(web: &Web, base: &str, function: &str, prompt: &str, watch: &Watch) -> Result<Vec<u8>, String> {
    let (root, info) = info(web)?;
    let inputs = inputs(&info, function, prompt)?;
    let call = format!("{root}/call/{function}");
    let said = json_of(&web.post(&call, json!({ "data": inputs })).map_err(told)?)?;
    let event = format!("{call}/{}", id(&said["event_id"])?);
    watch.say("waiting for its result");
    let stream = web.get(&event).map_err(told)?;
    let result = result(&String::from_utf8_lossy(&stream))?;
    let file = model(&result).ok_or("the app returned no GLB file")?;
    let url = match (file["url"].as_str(), file["path"].as_str()) {
        (Some(url), _) => url.to_owned(),
        (None, Some(path)) => format!("{base}{root}/file={path}"),
        (None, None) => return Err("the app returned a file without a path".to_owned()),
    };
    web.fetch(&url).map_err(told)
}

/// What the app says of its functions, and where its addresses are.
fn info(web: &Web) -> Result<(&'static str, Value), String> {
    let mut last = String::new();
    for root in ROOTS {
        match web.get(&format!("{root}/info")) {
            Ok(bytes) => return Ok((root, json_of(&bytes)?)),
            Err(Error::Refused { status: 404, .. }) => "there is no Gradio app at this address".clone_into(&mut last),
            Err(error) => return Err(told(error)),
        }
    }
    Err(last)
}

/// The inputs of a call.
fn inputs(info: &Value, function: &str, prompt: &str) -> Result<Vec<Value>, String> {
    let named = &info["named_endpoints"];
    let Some(parameters) = named[format!("/{function}")]["parameters"].as_array() else {
        let known = named.as_object().into_iter().flat_map(|all| all.keys()).map(|name| name.trim_start_matches('/'));
        let known = plain(&known.collect::<Vec<_>>().join(", "), 200);
        return Err(format!("the app has no function `{function}`; it has: {known}"));
    };
    let described = parameters.iter().position(|p| p["type"]["type"] == "string");
    let described = described.ok_or_else(|| format!("the function `{function}` has no input for a text"))?;
    let given = |(at, parameter): (usize, &Value)| match parameter["parameter_has_default"].as_bool() {
        _ if at == described => Ok(prompt.into()),
        Some(true) => Ok(parameter["parameter_default"].clone()),
        _ => {
            let name = plain(parameter["parameter_name"].as_str().unwrap_or("?"), 50);
            Err(format!("the input `{name}` of the function `{function}` has no default"))
        }
    };
    parameters.iter().enumerate().map(given).collect()
}

/// The result in a stream of events: the data of the event `complete`.
fn result(stream: &str) -> Result<Value, String> {
    let mut event = "";
    for line in stream.lines() {
        if let Some(name) = line.strip_prefix("event:") {
            event = name.trim();
        } else if let Some(data) = line.strip_prefix("data:") {
            match event {
                "complete" => return json_of(data.trim().as_bytes()),
                "error" => return Err(format!("the app could not make it: {}", plain(data.trim(), 200))),
                _ => {}
            }
        }
    }
    Err("the app's answer ended without a result".to_owned())
}

/// The first file of a result whose name ends with `.glb`.
fn model(result: &Value) -> Option<&Value> {
    match result {
        Value::Array(items) => items.iter().find_map(model),
        Value::Object(members) => {
            let is_model = |key: &str| members.get(key).and_then(Value::as_str).is_some_and(is_glb);
            if is_model("path") || is_model("url") { Some(result) } else { members.values().find_map(model) }
        }
        _ => None,
    }
}

fn is_glb(name: &str) -> bool {
    std::path::Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("glb"))
}
