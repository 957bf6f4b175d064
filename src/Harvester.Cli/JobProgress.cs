using System;
using System.Diagnostics;
using System.Globalization;
using Spectre.Console;

namespace Harvester.Cli;

/// <summary>Shows how far a long job is: a moving bar for a person, a line now and then for a file.</summary>
internal sealed class JobProgress
{
    private static readonly TimeSpan BetweenPlainLines = TimeSpan.FromSeconds(5);

    private readonly Terminal _terminal;
    private readonly int _all;
    private readonly string _unit;
    private readonly Stopwatch _clock = new();
    private TimeSpan _lastLine;

    /// <param name="terminal">Where it is shown.</param>
    /// <param name="all">How much there is to do.</param>
    /// <param name="unit">What it is counted in.</param>
    public JobProgress(Terminal terminal, int all, string unit = "frames")
    {
        _terminal = terminal;
        _all = all;
        _unit = unit;
    }

    /// <summary>Runs the job and shows what it reports.</summary>
    public T Run<T>(Func<Action<int>, T> job)
    {
        _clock.Start();
        return _terminal.IsInteractive ? RunInteractive(job) : job(WriteLine);
    }

    /// <summary>How far the job is: what is done, rate, time left.</summary>
    internal static string Describe(int done, int all, TimeSpan elapsed, string unit = "frames")
    {
        double rate = done / Math.Max(elapsed.TotalSeconds, 1e-3);
        double left = (all - done) / Math.Max(rate, 1e-3);
        return string.Create(CultureInfo.InvariantCulture, $"{done} of {all} {unit}, {rate:0.0} a second, {Duration(left)} left");
    }

    private static string Duration(double seconds)
    {
        TimeSpan time = TimeSpan.FromSeconds(Math.Ceiling(Math.Min(seconds, TimeSpan.MaxValue.TotalSeconds / 2)));
        return time < TimeSpan.FromMinutes(1)
            ? string.Create(CultureInfo.InvariantCulture, $"{time.TotalSeconds:0} s")
            : string.Create(CultureInfo.InvariantCulture, $"{Math.Floor(time.TotalMinutes):0} min {time.Seconds} s");
    }

    private T RunInteractive<T>(Func<Action<int>, T> job) =>
        _terminal.ToAnsiConsole().Progress()
            .AutoClear(true)
            .Columns(new ProgressBarColumn(), new PercentageColumn(), new TaskDescriptionColumn())
            .Start(context =>
            {
                ProgressTask task = context.AddTask("starting", maxValue: _all);
                return job(done =>
                {
                    task.Value = done;
                    task.Description = Describe(done, _all, _clock.Elapsed, _unit);
                });
            });

    private void WriteLine(int done)
    {
        TimeSpan now = _clock.Elapsed;
        if (now - _lastLine >= BetweenPlainLines && done < _all)
        {
            _lastLine = now;
            _terminal.Out.WriteLine(Describe(done, _all, now, _unit));
            _terminal.Out.Flush();
        }
    }
}
