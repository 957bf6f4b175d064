namespace Harvester.Sessions.Files;

/// <summary>
/// A file in a folder that a command is writing, with the command. It is there before everything else in the folder and is deleted last:
/// a folder that has it is the unfinished result of that command, whatever stopped it.
/// </summary>
public static class UnfinishedMark
{
    /// <summary>Name of the file.</summary>
    public const string FileName = ".harvester-unfinished";

    // Longer than any command line.
    private const int MaxCharacters = 4 << 20;

    // No command line has it.
    private const char Separator = '\0';

    /// <summary>The command under way in a folder; null for a folder without the mark.</summary>
    /// <exception cref="IOException">The file is a link, which would show another file, or cannot be read.</exception>
    /// <exception cref="System.UnauthorizedAccessException">The file cannot be read.</exception>
    public static string? CommandIn(string folder) => TextIn(folder)?.Split(Separator)[0];

    /// <summary>What the command has noted in its mark; empty for a folder without the mark.</summary>
    /// <exception cref="IOException">The file is a link, which would show another file, or cannot be read.</exception>
    /// <exception cref="System.UnauthorizedAccessException">The file cannot be read.</exception>
    public static IReadOnlyList<string> NotesIn(string folder) => [.. (TextIn(folder) ?? "").Split(Separator).Skip(1)];

    /// <summary>Whether a folder has the mark.</summary>
    public static bool IsIn(string folder) => File.Exists(PathIn(folder));

    /// <summary>Marks a folder, which must exist. The mark survives a loss of power, since what follows may.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command.</param>
    /// <param name="notes">What the command notes for when it is given again; without the character 0.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="System.UnauthorizedAccessException">The file cannot be written.</exception>
    public static void Write(string folder, string command, params string[] notes) =>
        AtomicFile.Write(PathIn(folder), string.Join(Separator.ToString(), [command, .. notes]));

    /// <summary>
    /// Takes the mark away, and what writing it left when it was stopped. A loss of power does not bring it back.
    /// </summary>
    /// <exception cref="IOException">The file cannot be deleted.</exception>
    /// <exception cref="System.UnauthorizedAccessException">The file may not be deleted.</exception>
    public static void Delete(string folder)
    {
        AtomicFile.DeleteLeftovers(folder, target => target == FileName);
        File.Delete(PathIn(folder));
        DiskSync.Folder(folder);
    }

    /// <summary>Whether a file is a mark or the temporary file of one.</summary>
    /// <param name="name">Its name without a folder.</param>
    public static bool Is(string name) => name == FileName || AtomicFile.TargetOf(name) == FileName;

    /// <summary>Whether a folder has nothing but its mark, also when writing that was stopped; true for an empty folder.</summary>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="System.UnauthorizedAccessException">The folder cannot be read.</exception>
    public static bool IsAllOf(string folder) => Directory.EnumerateFileSystemEntries(folder).All(entry => Is(Path.GetFileName(entry)));

    private static string PathIn(string folder) => Path.Combine(folder, FileName);

    private static string? TextIn(string folder)
    {
        string path = PathIn(folder);
        if (!File.Exists(path))
        {
            return null;
        }

        if (AppendedFile.IsLink(path))
        {
            throw new IOException($"'{path}' is a link, which is not followed. Delete it, or name another folder.");
        }

        using var text = new StreamReader(RegularFile.OpenRead(path));
        char[] command = new char[MaxCharacters];
        return new string(command, 0, text.ReadBlock(command, 0, MaxCharacters));
    }
}
