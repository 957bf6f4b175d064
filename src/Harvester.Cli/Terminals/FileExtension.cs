using Harvester.Runs.Faults;

namespace Harvester.Cli.Terminals;

/// <summary>The end of a file's name, which says its format.</summary>
internal static class FileExtension
{
    /// <summary>Checks that the name of an output file matches its format.</summary>
    /// <param name="option">The option that names the file.</param>
    /// <param name="file">The file.</param>
    /// <param name="allowed">The allowed ends, in any case.</param>
    /// <exception cref="UsageException">It ends otherwise.</exception>
    public static void Check(string option, string file, params string[] allowed)
    {
        if (!allowed.Contains(Path.GetExtension(file), StringComparer.OrdinalIgnoreCase))
        {
            throw new UsageException($"{option} takes a file that ends in {string.Join(" or ", allowed)}, not '{file}'.");
        }
    }
}
