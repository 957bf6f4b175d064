using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Recipes;

/// <summary>One digest of all files of a folder.</summary>
public static class FolderDigest
{
    /// <summary>
    /// SHA-256 of the lines "DIGEST  PATH", one for each file, in the order of their paths: the digest of a file, two spaces and its path
    /// below the folder with forward slashes, as sha256sum writes them.
    /// </summary>
    /// <param name="folder">The folder.</param>
    /// <param name="leftOut">Names of files that are left out, wherever they are.</param>
    /// <param name="cancellation">Stops before the next file.</param>
    /// <returns>64 hexadecimal digits in lower case.</returns>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static string Of(string folder, IReadOnlyCollection<string> leftOut, CancellationToken cancellation)
    {
        var lines = new StringBuilder();
        IOrderedEnumerable<string> paths = Directory
            .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Where(path => !leftOut.Contains(Path.GetFileName(path)))
            .Select(path => Path.GetRelativePath(folder, path).Replace(Path.DirectorySeparatorChar, '/'))
            .Order(StringComparer.Ordinal);
        foreach (string path in paths)
        {
            cancellation.ThrowIfCancellationRequested();
            lines.Append(FileDigest.OfFile(Path.Combine(folder, path)).Sha256).Append("  ").Append(path).Append('\n');
        }

        return FileDigest.Of(lines.ToString()).Sha256;
    }
}
