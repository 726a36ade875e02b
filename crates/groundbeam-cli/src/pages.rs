//! Prints completion scripts, the manual page and the JSON Schema, from the definitions of commands and file keys.

use crate::command::CommandLine;
use crate::failure::Failure;
use crate::output::print;
use crate::status::Status;
use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;
use groundbeam_file::{model_schema, study_schema};

pub fn completions(shell: Shell) -> Result<Status, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut CommandLine::command(), "groundbeam", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(Status::Done)
}

/// Prints the JSON Schema of study files or of model files.
pub fn schema(study: bool) -> Result<Status, Failure> {
    print(&if study { study_schema() } else { model_schema() })?;
    Ok(Status::Done)
}

/// Prints the manual page with all commands.
pub fn manual() -> Result<Status, Failure> {
    print(&page().map_err(|error| Failure::usage(error.to_string()))?)?;
    Ok(Status::Done)
}

fn page() -> std::io::Result<String> {
    let mut command = CommandLine::command();
    command.build();
    let whole = Man::new(command.clone());
    let mut page = Vec::new();
    whole.render_title(&mut page)?;
    whole.render_name_section(&mut page)?;
    whole.render_synopsis_section(&mut page)?;
    whole.render_description_section(&mut page)?;
    for part in command.get_subcommands().filter(|part| !part.is_hide_set()) {
        if part.get_name() != "help" {
            page.extend(section(part)?.bytes());
        }
    }
    // The request `.nf` preserves the line breaks of the notes on exit status and environment.
    let notes = command.get_after_long_help().map(ToString::to_string).unwrap_or_default();
    page.extend(format!(".SH NOTES\n.nf\n{notes}\n.fi\n").bytes());
    Ok(String::from_utf8_lossy(&page).into_owned())
}

/// Returns the section of the manual page about one command: its description, synopsis and options.
fn section(command: &clap::Command) -> std::io::Result<String> {
    let part = Man::new(command.clone());
    let mut text = Vec::new();
    part.render_description_section(&mut text)?;
    part.render_synopsis_section(&mut text)?;
    part.render_options_section(&mut text)?;
    let text = String::from_utf8_lossy(&text).replace(".SH ", ".SS ");
    let heading = command.get_name().to_uppercase();
    Ok(format!(".SH GROUNDBEAM {heading}\n{text}"))
}
