using System.Security.Cryptography;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>The files and folders below a folder, with the bytes of the files. Two are equal if all names and bytes are.</summary>
internal sealed class FolderContent : IEquatable<FolderContent>
{
    private readonly SortedDictionary<string, string> _entries = new(StringComparer.Ordinal);

    /// <summary>Paths within the folder, in ordinal order. Those of folders end in a slash.</summary>
    public string[] Names => [.. _entries.Keys];

    public static FolderContent Of(string folder)
    {
        var content = new FolderContent();
        if (!Directory.Exists(folder))
        {
            return content;
        }

        foreach (string path in Directory.EnumerateFileSystemEntries(folder, "*", SearchOption.AllDirectories))
        {
            string name = Path.GetRelativePath(folder, path).Replace('\\', '/');
            bool isFolder = Directory.Exists(path);
            content._entries.Add(
                isFolder ? name + "/" : name,
                isFolder ? "folder" : Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(path)))
            );
        }

        return content;
    }

    /// <summary>The same without some of the names.</summary>
    public FolderContent Without(Predicate<string> isLeftOut)
    {
        var content = new FolderContent();
        foreach ((string name, string bytes) in _entries.Where(entry => !isLeftOut(entry.Key)))
        {
            content._entries.Add(name, bytes);
        }

        return content;
    }

    /// <summary>Names of what lies directly in the folder.</summary>
    public IEnumerable<string> Tops => Names.Select(TopOf).Distinct(StringComparer.Ordinal);

    /// <summary>A file or folder that lies directly in the folder, with what is in it.</summary>
    public FolderContent In(string top) => Without(name => TopOf(name) != top);

    /// <summary>What is more, less or different, for a message.</summary>
    public string DifferenceFrom(FolderContent other) =>
        string.Join(
            ", ",
            Names
                .Except(other.Names)
                .Select(name => "+" + name)
                .Concat(other.Names.Except(Names).Select(name => "-" + name))
                .Concat(
                    _entries
                        .Where(entry => other._entries.TryGetValue(entry.Key, out string? bytes) && bytes != entry.Value)
                        .Select(entry => "~" + entry.Key)
                )
                .Take(12)
        );

    public bool Equals(FolderContent? other) => other is not null && _entries.SequenceEqual(other._entries);

    public override bool Equals(object? obj) => Equals(obj as FolderContent);

    public override int GetHashCode() => _entries.Count;

    public override string ToString() => string.Join('\n', _entries.Select(entry => $"{entry.Key} {entry.Value}"));

    private static string TopOf(string name) => name.Split('/')[0];
}
