namespace Harvester.TestSupport;

/// <summary>The folder of the repository that the tests were built from.</summary>
internal static class RepositoryFolder
{
    /// <summary>Absolute path.</summary>
    public static string Path { get; } = Find(AppContext.BaseDirectory);

    private static string Find(string folder) =>
        File.Exists(System.IO.Path.Combine(folder, "GtaDataHarvester.sln"))
            ? folder
            : Find(
                System.IO.Path.GetDirectoryName(folder)
                    ?? throw new DirectoryNotFoundException("GtaDataHarvester.sln is in no folder above the tests.")
            );
}
