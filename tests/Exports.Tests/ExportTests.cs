using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>Tests that export: a folder for what they write and a session to damage, both gone afterwards.</summary>
public abstract class ExportTests : IDisposable
{
    private TestSession? _session;

    private protected ExportFolder Folder { get; } = new();

    private protected TestSession Session => _session ??= new TestSession();

    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    protected virtual void Dispose(bool disposing)
    {
        Folder.Dispose();
        _session?.Dispose();
    }
}
