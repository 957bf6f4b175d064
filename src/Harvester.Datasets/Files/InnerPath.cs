using System;
using System.IO;
using System.Linq;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// The gate for every name that is read from a file and stands for a file beside it: it is relative, has no "..", and leads, with all links
/// resolved, to a place within the folder where no pipe, socket or device is. What passes may be missing.
/// </summary>
public static class InnerPath
{
    private const int MaxLinks = 40;

    /// <summary>Where a file lies.</summary>
    /// <param name="folder">The folder; it may be a link itself.</param>
    /// <param name="name">The file's path within it, with forward slashes.</param>
    /// <exception cref="DatasetFormatException">The name leads out of the folder, or to no regular file.</exception>
    public static string Of(string folder, string name) =>
        !IsName(name) ? throw new DatasetFormatException($"'{Shown(name)}' points out of '{folder}', or is no name of a file.")
        : Combined(folder, name) is var path && LeavesThroughLink(folder, name)
            ? throw new DatasetFormatException($"'{name}' is a link that points out of '{folder}'.")
        : RegularFile.IsSpecial(path) ? throw new DatasetFormatException($"'{name}' in '{folder}' is a pipe, a socket or a device.")
        : path;

    /// <summary>Whether a name stands for a place in a folder and leads, with all links resolved, to one.</summary>
    public static bool IsWithin(string folder, string name) => IsName(name) && !LeavesThroughLink(folder, name);

    /// <summary>A path with all links resolved, as far as it is there.</summary>
    /// <exception cref="IOException">Links lead round in a circle.</exception>
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

    /// <summary>Relative on every system, without a step upwards, and without characters that no file system or terminal bears.</summary>
    private static bool IsName(string name) =>
        name.Length > 0 && !Path.IsPathRooted(name) && name[0] is not ('/' or '\\')
            && !(OperatingSystem.IsWindows() && name.Contains(':', StringComparison.Ordinal))
        && !name.Any(char.IsControl) && !name.Split('/', '\\').Contains("..", StringComparer.Ordinal);

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

    /// <summary>The part of a path nearest to its root that is a link; null for none.</summary>
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
