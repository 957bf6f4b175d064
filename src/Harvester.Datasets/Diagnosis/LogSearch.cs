namespace Harvester.Datasets.Diagnosis;

/// <summary>Finds the logs of a game in its folder and in its scripts folder, given either of the two.</summary>
internal sealed class LogSearch
{
    private const string Scripts = "scripts";
    private static readonly string[] Programs = ["GTA5.exe", "GTA5_Enhanced.exe"];
    private static readonly EnumerationOptions AnyCase = new() { MatchCasing = MatchCasing.CaseInsensitive };
    private readonly string[] _folders;

    /// <summary>Searches the folders.</summary>
    public LogSearch(string folder)
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder));
        bool isScripts = string.Equals(Path.GetFileName(full), Scripts, StringComparison.OrdinalIgnoreCase);
        string game = isScripts && Path.GetDirectoryName(full) is { } parent ? parent : full;
        _folders = [game, .. Directory.EnumerateDirectories(game, Scripts, AnyCase)];
        Logs = Enum.GetValues<LogKind>()
            .Select(kind => (Kind: kind, Path: Find(LogFile.NameOf(kind))))
            .Where(found => found.Path is not null)
            .ToDictionary(found => found.Kind, found => found.Path!);
        IsGame =
            Programs.Any(program => Find(program) is not null) || Logs.ContainsKey(LogKind.ScriptHook) || Logs.ContainsKey(LogKind.Loader);
    }

    /// <summary>The logs found.</summary>
    public IReadOnlyDictionary<LogKind, string> Logs { get; }

    /// <summary>Whether this is the folder of a game, where a missing log is a finding.</summary>
    public bool IsGame { get; }

    private string? Find(string name) => _folders.SelectMany(folder => Directory.EnumerateFiles(folder, name, AnyCase)).FirstOrDefault();
}
