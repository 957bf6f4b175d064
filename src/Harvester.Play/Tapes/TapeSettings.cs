using System.Text;

namespace Harvester.Play.Tapes;

/// <summary>
/// The settings as a tape has them: without comments, and without what may be a path, an address or a person's name. A playback filters
/// them again, because a tape may come from anyone.
/// </summary>
public static class TapeSettings
{
    /// <summary>Settings that name files, folders, computers or the player.</summary>
    private static readonly string[] LeftOut =
    [
        "Folder",
        "File",
        "Rig",
        "Plate",
        "Address",
        "Port",
        "Token",
        "Kind",
        "Start",
        "MinFree",
        "Queue",
        "Record",
        "Minutes",
    ];

    private static readonly char[] OfPaths = ['/', '\\', ':', '%', '"', '<', '>', '@'];

    /// <summary>The lines of a settings file that a tape has.</summary>
    public static string Filter(TextReader settings)
    {
        if (settings is null)
        {
            throw new ArgumentNullException(nameof(settings));
        }

        var kept = new StringBuilder();
        while (settings.ReadLine() is { } line)
        {
            string text = line.Trim();
            if (text.Length > 0 && (IsSection(text) || IsKept(text)))
            {
                kept.Append(text).Append('\n');
            }
        }

        return kept.ToString();
    }

    private static bool IsSection(string line) =>
        line[0] == '[' && line[line.Length - 1] == ']' && line.Skip(1).Take(line.Length - 2).All(char.IsLetter);

    private static bool IsKept(string line)
    {
        string[] parts = line.Split(['='], 2);
        string name = parts[0].Trim();
        return parts.Length == 2
            && name.Length > 0
            && name.All(char.IsLetterOrDigit)
            && !LeftOut.Contains(name, StringComparer.OrdinalIgnoreCase)
            && !parts[1].Any(OfPaths.Contains)
            && !parts[1].Contains("..");
    }
}
