using System.Diagnostics;
using System.Globalization;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A run of the built command in a process of its own, with the largest memory that it was seen to have.</summary>
/// <param name="ExitCode">Its exit code.</param>
/// <param name="Error">What it wrote to standard error.</param>
/// <param name="PeakBytes">The largest resident memory (VmHWM); what grows in the last milliseconds is missed. Null off Linux.</param>
internal sealed record MeasuredRun(int ExitCode, string Error, long? PeakBytes)
{
    private static readonly string Program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(10);

    /// <summary>Runs a command to its end.</summary>
    public static MeasuredRun Of(params string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet", [Program, .. arguments]) { RedirectStandardError = true, RedirectStandardOutput = true };
        using Process process = Process.Start(start)!;
        process.OutputDataReceived += static (_, _) => { };
        process.BeginOutputReadLine();
        Task<string> error = process.StandardError.ReadToEndAsync();
        long? peak = null;
        while (!process.WaitForExit(Interval))
        {
            peak = PeakOf(process.Id) ?? peak;
        }

        return new MeasuredRun(process.ExitCode, error.Result, peak);
    }

    /// <summary>The largest resident memory that a running process has had, bytes; null off Linux.</summary>
    public static long? PeakOf(int process)
    {
        try
        {
            string? line = File.ReadLines($"/proc/{process}/status")
                .FirstOrDefault(each => each.StartsWith("VmHWM:", StringComparison.Ordinal));
            string[] words = line?.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries) ?? [];
            return words.Length < 2 ? null : 1024 * long.Parse(words[1], CultureInfo.InvariantCulture);
        }
        catch (IOException)
        {
            // It has just ended, or there is no /proc.
            return null;
        }
    }
}
