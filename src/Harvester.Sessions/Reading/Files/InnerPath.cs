using Harvester.Sessions.Files;

namespace Harvester.Sessions.Reading.Files;

/// <summary>
/// Resolves names of files that are read from other files. Such a name must be relative, without "..", and lead, with all links resolved,
/// to a place within the folder that is not a pipe, socket or device. The file may be missing.
/// </summary>
public static class InnerPath
{
    private const int MaxLinks = 40;

    /// <summary>The path of a file.</summary>
    /// <param name="folder">The folder; it may be a link itself.</param>
    /// <param name="name">Path of the file within the folder, with forward slashes.</param>
    /// <exception cref="DatasetFormatException">The name points outside the folder, or not to a regular file.</exception>
    public static string Of(string folder, string name) =>
        !IsName(name) ? throw new DatasetFormatException($"'{Shown(name)}' points outside '{folder}', or is not a valid file name.")
        : Combined(folder, name) is var path && LeavesThroughLink(folder, name)
            ? throw new DatasetFormatException($"'{name}' is a link that points outside '{folder}'.")
        : RegularFile.IsSpecial(path) ? throw new DatasetFormatException($"'{name}' in '{folder}' is a pipe, a socket or a device.")
        : path;

    /// <summary>Whether a name, with all links resolved, leads to a place within a folder.</summary>
    public static bool IsWithin(string folder, string name) => IsName(name) && !LeavesThroughLink(folder, name);

    /// <summary>A path with all links resolved, as far as it exists.</summary>
    /// <exception cref="IOException">The links form a cycle.</exception>
    public static string Resolve(string path)
    {
        string resolved = Path.GetFullPath(path);
        for (int i = 0; i < MaxLinks; i++)
        {
            if (FirstLink(resolved) is not { } link)
            {
                return resolved;
            }

            string target = Path.GetFullPath(LinkTarget(link)!, Path.GetDirectoryName(link)!);
            resolved = Path.GetFullPath(Path.Combine(target, Path.GetRelativePath(link, resolved)));
        }

        throw new IOException($"'{path}' leads through more than {MaxLinks} links. Name the file itself.");
    }

    /// <summary>
    /// Whether a name is relative on every system, without "..", and without characters that file systems or terminals do not allow.
    /// </summary>
    private static bool IsName(string name) =>
        name.Length > 0
        && !Path.IsPathRooted(name)
        && name[0] is not ('/' or '\\')
        && !(OperatingSystem.IsWindows() && name.Contains(':', StringComparison.Ordinal))
        && !name.Any(char.IsControl)
        && !name.Split('/', '\\').Contains("..", StringComparer.Ordinal);

    private static string Combined(string folder, string name) => Path.Combine(folder, name.Replace('/', Path.DirectorySeparatorChar));

    private static bool LeavesThroughLink(string folder, string name)
    {
        string path = Combined(folder, name);
        for (string? part = path; part is not null && part.Length > folder.Length; part = Path.GetDirectoryName(part))
        {
            if (LinkTarget(part) is not null)
            {
                return !IsBelow(Resolve(folder), Resolve(path));
            }
        }

        return false;
    }

    private static bool IsBelow(string folder, string path) =>
        path.StartsWith(Path.TrimEndingDirectorySeparator(folder) + Path.DirectorySeparatorChar, StringComparison.Ordinal);

    /// <summary>The first part of a path, from its root, that is a link; null for none.</summary>
    private static string? FirstLink(string path)
    {
        string? found = null;
        for (string? part = path; part is not null; part = Path.GetDirectoryName(part))
        {
            found = LinkTarget(part) is null ? found : part;
        }

        return found;
    }

    private static string? LinkTarget(string path) => new FileInfo(path).LinkTarget;

    private static string Shown(string name) => string.Concat(name.Select(c => char.IsControl(c) ? '?' : c));
}
