using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Terminals;

/// <summary>Refuses a command line that names the same folder twice, or one folder inside another, for different files.</summary>
internal static class SeparateFolders
{
    private static readonly StringComparison PathComparison = OperatingSystem.IsLinux()
        ? StringComparison.Ordinal
        : StringComparison.OrdinalIgnoreCase;

    /// <summary>Checks each pair of folders that a command line names. Changes nothing.</summary>
    /// <param name="named">The options and their folders; null for an option that is not given.</param>
    /// <exception cref="UsageException">With links resolved, a folder is another or lies inside it.</exception>
    /// <exception cref="IOException">A path leads through a cycle of links.</exception>
    public static void Check(params (string Option, string? Folder)[] named)
    {
        (string Option, string Folder, string Path)[] given =
        [
            .. named.Where(one => one.Folder is not null).Select(one => (one.Option, one.Folder!, PathOf(one.Folder!))),
        ];
        for (int i = 0; i < given.Length; i++)
        {
            foreach ((string Option, string Folder, string Path) other in given[(i + 1)..])
            {
                if (given[i].Path.Equals(other.Path, PathComparison))
                {
                    throw new UsageException(
                        $"{given[i].Option} and {other.Option} name the same folder, '{other.Folder}'. Name a folder of its own for each."
                    );
                }

                RefuseInside(given[i], other);
                RefuseInside(other, given[i]);
            }
        }
    }

    private static void RefuseInside((string Option, string Folder, string Path) inner, (string Option, string Folder, string Path) outer)
    {
        if (inner.Path.StartsWith(outer.Path, PathComparison))
        {
            throw new UsageException(
                $"The folder of {inner.Option}, '{inner.Folder}', is inside that of {outer.Option}, '{outer.Folder}'. "
                    + "Name two folders of which neither is inside the other."
            );
        }
    }

    /// <summary>The full path with a separator at its end, so that no folder begins like one beside it.</summary>
    private static string PathOf(string folder)
    {
        string path = InnerPath.Resolve(folder);
        return Path.EndsInDirectorySeparator(path) ? path : path + Path.DirectorySeparatorChar;
    }
}
