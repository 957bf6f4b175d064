using System.Diagnostics;
using System.Text.Json.Nodes;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>The viewer's memory is limited whatever the lines of a session are.</summary>
[Trait("Category", "Heavy")]
public sealed class ViewedLinesTests(ITestOutputHelper output) : IDisposable
{
    // Well below the limit of 1 GB for any input.
    private const long MaxBytes = 500_000_000;

    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    private readonly BombFolder _bombs = new();

    public void Dispose() => _bombs.Dispose();

    [Theory]
    [InlineData("\n", 200)]
    [InlineData("{}\n", 200)]
    [InlineData("[", 200)]
    public async Task Lines_without_labels_take_little_memory(string again, int megabytes)
    {
        _bombs.File("session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 } }""");
        await File.AppendAllTextAsync(_bombs.File("labels.jsonl", "", again, megabytes), "\n");
        string program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
        using Process viewer = Process.Start(
            new ProcessStartInfo("dotnet", [program, "view", _bombs.Folder]) { RedirectStandardOutput = true }
        )!;
        try
        {
            string address = (await viewer.StandardOutput.ReadLineAsync())!;
            JsonNode state = await FinalStateAsync(new Uri(address));
            long peak = MeasuredRun.PeakOf(viewer.Id) ?? 0;
            output.WriteLine($"{peak / 1_000_000} MB: {state}");
            Assert.InRange(peak, 0, MaxBytes);
            Assert.True((int)state["problems"]! > 0, $"{state}");
        }
        finally
        {
            viewer.Kill();
            await viewer.WaitForExitAsync();
        }
    }

    /// <summary>What the viewer reports when it has read all that it reads.</summary>
    private static async Task<JsonNode> FinalStateAsync(Uri address)
    {
        using var client = new HttpClient();
        var time = Stopwatch.StartNew();
        while (true)
        {
            JsonNode state = JsonNode.Parse(await client.GetStringAsync(new Uri(address, "state")))!;
            if ((bool)state["isIndexed"]! && (state["limit"] is not null || (int)state["read"]! == (int)state["frames"]!))
            {
                return state;
            }

            Assert.True(time.Elapsed < Patience, $"{state}");
            await Task.Delay(50);
        }
    }
}
