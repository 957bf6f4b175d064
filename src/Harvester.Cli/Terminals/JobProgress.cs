using System.Diagnostics;
using System.Globalization;
using Spectre.Console;

namespace Harvester.Cli.Terminals;

/// <summary>Shows the progress of a long job: a progress bar in a terminal, a line every few seconds in a file or pipe.</summary>
internal sealed class JobProgress
{
    private static readonly TimeSpan BetweenPlainLines = TimeSpan.FromSeconds(5);

    private readonly Terminal _terminal;
    private readonly int _all;
    private readonly string _unit;
    private readonly Stopwatch _clock = new();
    private readonly JobRate _rate = new();
    private TimeSpan _lastLine;

    /// <param name="terminal">Receives the progress.</param>
    /// <param name="all">The amount of work.</param>
    /// <param name="unit">Unit of the amount, in the plural.</param>
    public JobProgress(Terminal terminal, int all, string unit = "frames")
    {
        _terminal = terminal;
        _all = all;
        _unit = unit;
    }

    /// <summary>Runs the job and shows the progress it reports.</summary>
    public T Run<T>(Func<Action<int>, T> job)
    {
        _clock.Start();
        return _terminal.IsInteractive ? RunInteractive(job) : job(WriteLine);
    }

    /// <summary>The progress as text: what is done, and, if the rate is known, rate and time left.</summary>
    /// <param name="done">The work done.</param>
    /// <param name="all">The amount of work.</param>
    /// <param name="perSecond">The rate, greater than 0; null if unknown.</param>
    /// <param name="unit">Unit of the amount, in the plural.</param>
    internal static string Describe(int done, int all, double? perSecond, string unit = "frames") =>
        perSecond is { } rate
            ? string.Create(
                CultureInfo.InvariantCulture,
                $"{done} of {all} {unit}, {rate:0.0} {unit}/s, {Duration((all - done) / rate)} left"
            )
            : string.Create(CultureInfo.InvariantCulture, $"{done} of {all} {unit}");

    private static string Duration(double seconds)
    {
        TimeSpan time = TimeSpan.FromSeconds(Math.Ceiling(Math.Min(seconds, TimeSpan.MaxValue.TotalSeconds / 2)));
        return time < TimeSpan.FromMinutes(1) ? string.Create(CultureInfo.InvariantCulture, $"{time.TotalSeconds:0} s")
            : time < TimeSpan.FromHours(1) ? string.Create(CultureInfo.InvariantCulture, $"{time.Minutes} min {time.Seconds} s")
            : string.Create(CultureInfo.InvariantCulture, $"{Math.Floor(time.TotalHours):0} h {time.Minutes} min");
    }

    private T RunInteractive<T>(Func<Action<int>, T> job) =>
        _terminal
            .ToAnsiConsole()
            .Progress()
            .AutoClear(true)
            .Columns(new ProgressBarColumn(), new PercentageColumn(), new TaskDescriptionColumn())
            .Start(context =>
            {
                ProgressTask task = context.AddTask("starting", maxValue: _all);
                return job(done =>
                {
                    task.Value = done;
                    task.Description = Describe(done, _all, _rate.Report(done, _clock.Elapsed), _unit);
                });
            });

    private void WriteLine(int done)
    {
        TimeSpan now = _clock.Elapsed;
        double? rate = _rate.Report(done, now);
        if (now - _lastLine >= BetweenPlainLines && done < _all)
        {
            _lastLine = now;
            _terminal.Out.WriteLine(Describe(done, _all, rate, _unit));
            _terminal.Out.Flush();
        }
    }
}
