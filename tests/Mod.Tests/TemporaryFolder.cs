namespace Harvester.Mod.Tests;

/// <summary>A folder that goes when the test ends.</summary>
internal sealed class TemporaryFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("harvester-mod-").FullName;

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
