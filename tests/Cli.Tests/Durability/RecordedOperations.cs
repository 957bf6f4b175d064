using System.Diagnostics;
using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Durability;

/// <summary>The operations on files of one run of the command, each as kind and path, e.g. "rename out/export.json".</summary>
internal sealed class RecordedOperations
{
    private readonly List<string> _operations;

    private RecordedOperations(List<string> operations) => _operations = operations;

    public static RecordedOperations Of(string folder, params string[] words)
    {
        string library = FaultInjector.Compile(Directory.CreateDirectory(folder + "-library").FullName);
        var start = new ProcessStartInfo("dotnet", [typeof(Program).Assembly.Location, "operations", library, folder, .. words])
        {
            RedirectStandardOutput = true,
        };
        start.Environment["LD_PRELOAD"] = library;
        using Process driver = Process.Start(start)!;
        string report = driver.StandardOutput.ReadToEnd();
        driver.WaitForExit();
        Assert.True(driver.ExitCode == 0, report);
        return new RecordedOperations([.. report.Split('\n', StringSplitOptions.RemoveEmptyEntries)]);
    }

    /// <summary>Paths of the operations of a kind, in their order.</summary>
    public IEnumerable<string> Paths(string kind) =>
        _operations
            .Where(operation => operation.StartsWith(kind + " ", StringComparison.Ordinal))
            .Select(operation => operation[(kind.Length + 1)..]);

    /// <summary>
    /// Checks that operations come in this order, each after the one before. To flush what another process or stream has written, or a
    /// folder, is to open it.
    /// </summary>
    public void AssertOrder(params string[] expected)
    {
        int last = -1;
        foreach (string operation in expected)
        {
            last = _operations.IndexOf(operation, last + 1);
            Assert.True(last >= 0, $"Not in this place: {operation}\n{string.Join('\n', _operations)}");
        }
    }
}
