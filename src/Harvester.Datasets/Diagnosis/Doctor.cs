using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Reads the logs of a game with the mod, a session or a self-test, and names the likely cause of a problem.</summary>
public static class Doctor
{
    /// <summary>Reads a log, the folder of the game or of its scripts, a session, or the result of a self-test.</summary>
    /// <param name="path">The file or folder.</param>
    /// <param name="allRuns">Whether earlier runs in the mod's log are included.</param>
    /// <exception cref="IOException">A file is missing or cannot be read.</exception>
    /// <exception cref="DatasetFormatException">The file is neither a log nor the result of a self-test; the folder has no logs and is not
    /// the game's; or session.json is invalid.</exception>
    public static Diagnosis Examine(string path, bool allRuns = false)
    {
        if (!Directory.Exists(path) && SelfTestFile.HasName(path))
        {
            SelfTestFile test = SelfTestFile.Read(path);
            return new Diagnosis([], [.. SelfTestRules.Of(test, Path.GetFileName(path))]) { SelfTest = test };
        }

        if (!Directory.Exists(path))
        {
            LogFile log = LogFile.Read(path, allRuns);
            return new Diagnosis([log], [.. FindingsOf(log)]);
        }

        return File.Exists(Path.Combine(path, SessionInfo.FileName))
            ? new Diagnosis([], [.. SessionCheck.Of(new SessionReader(path).ReadInfo())])
            : ExamineGame(path, allRuns);
    }

    private static Diagnosis ExamineGame(string folder, bool allRuns)
    {
        var search = new LogSearch(folder);
        if (!search.IsGame && search.Logs.Count == 0)
        {
            throw new DatasetFormatException(
                $"'{folder}' has no log of the mod, and is neither the game's folder nor a session. Name one of these."
            );
        }

        // From the lowest layer up: a problem in a lower layer causes those in higher layers.
        LogFile[] logs = [.. search.Logs.OrderBy(log => log.Key).Select(log => LogFile.Read(log.Value, allRuns))];
        IEnumerable<Finding> missing = search.IsGame ? MissingLogCheck.Of(logs) : [];
        return new Diagnosis(
            logs,
            [
                .. logs.Where(log => log.Kind != LogKind.Mod).SelectMany(FindingsOf),
                .. missing,
                .. logs.Where(log => log.Kind == LogKind.Mod).SelectMany(FindingsOf),
            ]
        );
    }

    private static IEnumerable<Finding> FindingsOf(LogFile log) =>
        [.. log.Kind == LogKind.Mod ? EntryCheck.Of(log) : [], .. log.Runs.SelectMany(run => FindingsOf(log.Kind, run))];

    private static IEnumerable<Finding> FindingsOf(LogKind kind, IReadOnlyList<LogLine> run) =>
        kind switch
        {
            LogKind.ScriptHook => LineRule.Apply(ScriptHookRules.All, run),
            LogKind.Loader => LineRule.Apply(LoaderRules.All, run),
            _ => [.. VersionCheck.Of(run), .. LineRule.Apply(ModRules.All, run), .. DiscardCheck.Of(run), .. RunCheck.Of(run)],
        };
}
