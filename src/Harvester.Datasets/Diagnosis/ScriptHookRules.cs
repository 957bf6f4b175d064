namespace Harvester.Datasets.Diagnosis;

/// <summary>Problems in ScriptHookV.log.</summary>
internal static class ScriptHookRules
{
    public static readonly IReadOnlyList<LineRule> All =
    [
        new(
            "unknown game version",
            "ScriptHookV is older than the game.",
            "Install the ScriptHookV for this build of the game; after an update of the game, it may take some days to appear."
        ),
        new(
            "can't find native (0x[0-9A-F]+)",
            "A mod calls a native function ($1) that this build of the game does not have.",
            "Update the game and the mods; remove mods one by one to find the one that calls it."
        ),
        new(
            "exception occurred while executing 'ScriptHookVDotNet[^']*'",
            "ScriptHookVDotNet crashed.",
            "Install the version of ScriptHookVDotNet for this build of the game: the latest nightly for Legacy builds after 1.0.3179, "
                + "or ScriptHookVDotNetEnhanced for Enhanced."
        ),
        new("exception occurred while executing '([^']+)'", "Another mod crashed: $1.", "Update or remove it."),
    ];
}
