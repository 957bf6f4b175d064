namespace Harvester.Datasets.Diagnosis;

/// <summary>Explains logs that are missing or do not mention the next layer.</summary>
internal static class MissingLogCheck
{
    private const string LoaderAsi = "ScriptHookVDotNet.asi";
    private const string Mod = "GtaDataHarvester";

    /// <summary>The finding for the lowest missing layer, if any; that higher layers are missing follows from it.</summary>
    /// <param name="logs">The logs in the folder of a game.</param>
    public static IEnumerable<Finding> Of(IReadOnlyList<LogFile> logs)
    {
        LogFile? hook = logs.FirstOrDefault(log => log.Kind == LogKind.ScriptHook);
        LogFile? loader = logs.FirstOrDefault(log => log.Kind == LogKind.Loader);
        bool hasMod = logs.Any(log => log.Kind == LogKind.Mod);
        if (hook is null && loader is null)
        {
            yield return new Finding(
                "ScriptHookV was not loaded: the game runs with BattlEye, or ScriptHookV is not in the game's folder.",
                "Disable BattlEye in the launcher or start the game with -nobattleye; put ScriptHookV.dll and dinput8.dll next to the "
                    + "game's program."
            );
        }
        else if (loader is null || (hook is not null && !Mentions(hook, LoaderAsi)))
        {
            yield return new Finding(
                "ScriptHookVDotNet was not loaded.",
                "Put its .asi, .dll and .ini files into the game's folder; it needs .NET Framework 4.8 and the Visual C++ "
                    + "Redistributable."
            );
        }
        else if (!Mentions(loader, Mod))
        {
            yield return new Finding(
                "ScriptHookVDotNet found no GtaDataHarvester.dll.",
                "Copy the files of the mod's zip directly into the folder 'scripts' in the game's folder."
            );
        }
        else if (!hasMod)
        {
            yield return new Finding(
                "The mod wrote no log: it failed to load, or has no write access to its folder.",
                "Read what ScriptHookVDotNet.log says about it, and allow the game to write to the folder 'scripts'."
            );
        }
    }

    private static bool Mentions(LogFile log, string name) =>
        log.Runs.SelectMany(run => run).Any(line => line.Text.Contains(name, StringComparison.OrdinalIgnoreCase));
}
