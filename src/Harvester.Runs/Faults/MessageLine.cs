namespace Harvester.Runs.Faults;

/// <summary>Messages as single lines. They quote the content of files, which may be hostile.</summary>
public static class MessageLine
{
    private const int MaxLength = 600;

    /// <summary>Any text as one line of limited length, without control characters, which a terminal would obey.</summary>
    public static string Of(string text)
    {
        string line = string.Join(' ', text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        line = string.Concat(line.Where(character => !char.IsControl(character)));
        return line.Length <= MaxLength ? line : line[..MaxLength] + "...";
    }
}
