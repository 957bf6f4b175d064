using System.Collections.Concurrent;
using System.Diagnostics;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Faults in every single file operation of every command that writes; docs/reliability.md has the figures.</summary>
public sealed class FaultInjectionTests(ITestOutputHelper output) : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Command_with_any_failed_operation_can_be_repeated()
    {
        string library = FaultInjector.Compile(_folder.Path);
        CommandTrial.MakeInputs(_folder.PathOf("inputs"));
        FolderContent inputs = FolderContent.Of(_folder.PathOf("inputs"));
        var names = new ConcurrentQueue<string>(
            WritingCommand.Chosen.OrderByDescending(command => command.BuildsWorld).Select(command => command.Name)
        );
        var reports = new ConcurrentQueue<string>();
        Task.WaitAll([
            .. Enumerable
                .Range(0, Environment.ProcessorCount)
                .Select(driver =>
                    Task.Factory.StartNew(
                        () => Drive(library, _folder.PathOf($"work-{driver}"), names, reports),
                        CancellationToken.None,
                        TaskCreationOptions.LongRunning,
                        TaskScheduler.Default
                    )
                ),
        ]);
        output.WriteLine(string.Join('\n', reports));

        Assert.Equal(WritingCommand.Chosen.Count, reports.Count);
        Assert.All(reports, report => Assert.Contains(", 0 failures,", report, StringComparison.Ordinal));
        Assert.Equal(inputs, FolderContent.Of(_folder.PathOf("inputs")));
    }

    /// <summary>Lets a process inject the faults of one command after another until there is none left.</summary>
    private void Drive(string library, string work, ConcurrentQueue<string> names, ConcurrentQueue<string> reports)
    {
        string[] arguments = [typeof(Program).Assembly.Location, "faults", library, _folder.PathOf("inputs"), work];
        var start = new ProcessStartInfo("dotnet", arguments) { RedirectStandardInput = true, RedirectStandardOutput = true };
        start.Environment["LD_PRELOAD"] = library;
        using Process driver = Process.Start(start)!;
        while (names.TryDequeue(out string? name))
        {
            driver.StandardInput.WriteLine(name);
            var report = new List<string>();
            while (driver.StandardOutput.ReadLine() is { Length: > 0 } line)
            {
                report.Add(line);
            }

            Assert.True(report.Count > 0, $"The process has ended in the faults of {name}.");
            reports.Enqueue(string.Join('\n', report));
        }

        driver.StandardInput.Close();
        driver.WaitForExit();
    }
}
