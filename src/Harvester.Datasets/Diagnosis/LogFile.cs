using System.Text.RegularExpressions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Diagnosis;

/// <summary>
/// A log. The mod's log has all runs since it was installed, of which usually only the last matters; the other logs have one run.
/// </summary>
public sealed class LogFile
{
    private static readonly Regex RunBegins = new(@"^\S+ \S+ GtaDataHarvester \d+[.]\d+[^,]*, API ", RegexOptions.CultureInvariant);

    private LogFile(LogKind kind, string path, IReadOnlyList<IReadOnlyList<LogLine>> runs, int runsLeftAside)
    {
        Kind = kind;
        Path = path;
        Runs = runs;
        RunsLeftAside = runsLeftAside;
    }

    /// <summary>The program that wrote the log.</summary>
    public LogKind Kind { get; }

    /// <summary>Path of the log.</summary>
    public string Path { get; }

    /// <summary>The lines of each run, the earliest first; at least one run.</summary>
    public IReadOnlyList<IReadOnlyList<LogLine>> Runs { get; }

    /// <summary>Number of earlier runs that were skipped.</summary>
    public int RunsLeftAside { get; }

    /// <summary>The default file name of a kind of log.</summary>
    public static string NameOf(LogKind kind) =>
        kind switch
        {
            LogKind.ScriptHook => "ScriptHookV.log",
            LogKind.Loader => "ScriptHookVDotNet.log",
            _ => "GtaDataHarvester.log",
        };

    /// <summary>Largest size of a log, bytes; a day's harvest writes less than a tenth of it.</summary>
    private const long MaxBytes = 64 << 20;

    private const int MaxLines = 1_000_000;

    /// <summary>
    /// Reads a log, even while the game is writing it. Its kind is detected from its name, which may have additions, or from its content.
    /// </summary>
    /// <param name="path">The file.</param>
    /// <param name="allRuns">Whether earlier runs are kept.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">The file is not one of the three logs.</exception>
    public static LogFile Read(string path, bool allRuns = false)
    {
        string name = System.IO.Path.GetFileName(path);
        LogKind? kind = KindByName(name);
        var runs = new List<List<LogLine>> { new() };
        int begun = 0;
        int number = 0;
        using TextReader file = new LimitedTextReader(new StreamReader(OpenShort(path)), name);
        while (file.ReadLine() is { } text)
        {
            if (++number > MaxLines)
            {
                throw TooLong(path);
            }

            if (RunBegins.IsMatch(text))
            {
                BeginRun(runs, keepEarlier: allRuns && begun > 0);
                begun++;
            }

            kind ??= KindByText(text);
            runs[^1].Add(new LogLine(name, number, text));
        }

        return new LogFile(
            kind
                ?? (
                    begun > 0
                        ? LogKind.Mod
                        : throw new DatasetFormatException($"'{path}' is not a log of the mod, ScriptHookVDotNet or ScriptHookV.")
                ),
            path,
            runs,
            Math.Max(0, begun - runs.Count)
        );
    }

    private static void BeginRun(List<List<LogLine>> runs, bool keepEarlier)
    {
        if (keepEarlier)
        {
            runs.Add([]);
        }
        else
        {
            runs[^1].Clear();
        }
    }

    private static LogKind? KindByName(string name)
    {
        return Has("ScriptHookVDotNet") ? LogKind.Loader
            : Has("ScriptHookV") ? LogKind.ScriptHook
            : Has("GtaDataHarvester") ? LogKind.Mod
            : null;

        bool Has(string part) => name.Contains(part, StringComparison.OrdinalIgnoreCase);
    }

    private static FileStream OpenShort(string path)
    {
        FileStream file = RegularFile.OpenRead(path, FileShare.ReadWrite | FileShare.Delete);
        if (file.Length <= MaxBytes)
        {
            return file;
        }

        file.Dispose();
        throw TooLong(path);
    }

    private static DatasetFormatException TooLong(string path) =>
        new(FormattableString.Invariant($"'{path}' is larger than {MaxBytes} bytes or {MaxLines} lines. Keep only its last part."));

    private static LogKind? KindByText(string text) =>
        text.Contains("GTA V SCRIPT HOOK", StringComparison.Ordinal) ? LogKind.ScriptHook
        : text.Contains("Loading API from", StringComparison.Ordinal) ? LogKind.Loader
        : null;
}
