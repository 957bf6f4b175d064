namespace Harvester.Datasets.Diagnosis;

/// <summary>Problems in ScriptHookVDotNet.log. The patterns match the texts of release 3.0.0 and later.</summary>
internal static class LoaderRules
{
    private const string UpdateLoader =
        "Install the version for this build of the game: the latest nightly for Legacy builds after 1.0.3179, or "
        + "ScriptHookVDotNetEnhanced for Enhanced.";

    private const string InstallAgain = "Copy the mod's files from the zip again.";

    public static readonly IReadOnlyList<LineRule> All =
    [
        new(
            "unable to resolve API version (.*GtaDataHarvester|[0-9.]+$)",
            "ScriptHookVDotNet is older than 3.6.0, which the mod needs.",
            UpdateLoader
        ),
        new(
            "GtaDataHarvester.*(0x80131515|network location)",
            "Windows blocks the mod's dll because it was downloaded.",
            "Open the properties of scripts/GtaDataHarvester.dll, tick Unblock, and start the game again."
        ),
        new("native ?memory", "ScriptHookVDotNet does not know this build of the game: it cannot read its memory.", UpdateLoader),
        new(
            "scripts because the .* directory is missing",
            "There is no folder 'scripts' in the game's folder.",
            "Create it, and copy the mod's files into it."
        ),
        new(
            "no scripting API|ScriptHookVDotNet3[.]dll is not loaded|unable to load ScriptHookVDotNet",
            "The installation of ScriptHookVDotNet is incomplete.",
            "Copy its .asi, .dll and .ini files into the game's folder; unblock them in their properties."
        ),
        new(
            "script name Harvester[.].* already exists",
            "The mod is installed twice.",
            "Keep a single GtaDataHarvester.dll, directly in the folder 'scripts'."
        ),
        new(
            "found (0 script|no compatible scripts).*GtaDataHarvester|unable to load GtaDataHarvester|failed to load .*GtaDataHarvester"
                + "|ignoring assembly file GtaDataHarvester",
            "The mod's dll cannot be loaded.",
            InstallAgain + " .NET Framework 4.8 or newer is needed."
        ),
        new(
            "failed to instantiate script Harvester[.]",
            "The mod failed to start.",
            InstallAgain + " If it fails again, report it with this log."
        ),
        new(
            "script '?Harvester[.].* is not responding|blocking script! script Harvester[.]",
            "A tick of the mod took so long that ScriptHookVDotNet ended it.",
            "Reload the scripts. If it happens again, report it with both logs."
        ),
        new("executing the script Harvester[.]", "The mod failed unexpectedly.", "Reload the scripts, and report it with both logs."),
    ];
}
