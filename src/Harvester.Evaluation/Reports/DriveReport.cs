using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using Harvester.Evaluation.Figures;
using Harvester.Geometry;

namespace Harvester.Evaluation.Reports;

/// <summary>Shows a drive as one page that needs nothing beside it: figures, the way on a map, lateral error, speed, jerk and progress.</summary>
public static class DriveReport
{
    /// <summary>Name of the page.</summary>
    public const string FileName = "report.html";

    private const string ByController = "controller";
    private const string ByOwnDriver = "own";

    private const string Style = """
        body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 980px; padding: 0 1em; color: #1c1e21; background: #fff; }
        h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin: 1.6em 0 .4em; }
        table { border-collapse: collapse; } td { padding: .15em 1.2em .15em 0; } td + td { font-variant-numeric: tabular-nums; }
        svg { width: 100%; height: auto; } svg text { font-size: 12px; fill: #555; } .grid { stroke: #e4e6e8; }
        polyline { fill: none; stroke-width: 1.6; } .controller { stroke: #0969da; } .own { stroke: #aab0b7; } .bound { stroke: #cf8a00; stroke-dasharray: 5 4; }
        circle { fill: none; stroke-width: 2.5; } .departure { stroke: #cf8a00; } .collision { stroke: #cf222e; }
        b.controller { color: #0969da; } b.own { color: #7d848c; } b.departure { color: #9a6700; } b.collision { color: #cf222e; }

        """;

    /// <summary>Writes the page under a temporary name and then gives it its own.</summary>
    /// <param name="path">Where it goes.</param>
    /// <param name="record">What was driven, and what it came to.</param>
    /// <param name="samples">The drive.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(string path, DriveRecord record, IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(record);
        ArgumentNullException.ThrowIfNull(samples);
        StringBuilder page = new();
        page.Append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Drive report</title>\n<style>\n");
        page.Append(Style).Append("</style>\n</head>\n<body>\n");
        page.Append(CultureInfo.InvariantCulture, $"<h1>Drive by {WebUtility.HtmlEncode(record.Settings["controller"])}</h1>\n<p>");
        page.Append(WebUtility.HtmlEncode(string.Join(" · ", record.Settings.Select(setting => $"{setting.Key}: {setting.Value}"))));
        page.Append("</p>\n<table>\n");
        foreach ((string name, string value) in record.Figures.Rows())
        {
            page.Append(CultureInfo.InvariantCulture, $"<tr><td>{name}</td><td>{value}</td></tr>\n");
        }

        page.Append("</table>\n");
        if (samples.Count > 1)
        {
            page.Append("<h2>Way</h2>\n<p><b class=\"controller\">The controller</b> drives where lanes are known; <b class=\"own\">the car's own driver</b> through junctions and where he has to give way. Rings: <b class=\"departure\">lane departures</b>, <b class=\"collision\">collisions</b>.</p>\n");
            page.Append(Way(record, samples));
            page.Append("<h2>Distance from the middle of the lane</h2>\n<p>Metres to the right, while the controller drives outside of junctions; a change of lane jumps. Dashed: where the car's side reaches the marking of a lane of 5.4 m.</p>\n");
            page.Append(Lateral(samples));
            page.Append("<h2>Speed</h2>\n");
            page.Append(Speed(samples));
            page.Append("<h2>Jerk</h2>\n<p>Change of the acceleration while the controller drives.</p>\n");
            page.Append(JerkOf(samples));
            page.Append("<h2>Progress</h2>\n");
            page.Append(Progress(samples));
        }

        page.Append("</body>\n</html>\n");
        string temporary = path + ".tmp";
        File.WriteAllText(temporary, page.ToString(), new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));
        File.Move(temporary, path, overwrite: true);
    }

    private static string Way(DriveRecord record, IReadOnlyList<DriveSample> samples)
    {
        Plot map = Plot.Map(samples.Select(sample => sample.Position));
        AddByDriver(map, samples, (sample, _) => sample.Position);
        foreach (DriveEvent departure in record.Departures)
        {
            map.Mark("departure", departure.Place, departure.Words);
        }

        foreach (DriveEvent collision in record.Collisions)
        {
            map.Mark("collision", collision.Place, collision.Words);
        }

        return map.ToSvg();
    }

    private static string Lateral(IReadOnlyList<DriveSample> samples)
    {
        const double halfLane = 2.7;
        const double halfCar = 1.02;
        double[] way = Way(samples);
        Plot plot = Plot.Of("way, m", "right of the middle, m", (0, way[^1]), (-halfLane, halfLane));
        foreach (double bound in new[] { halfCar - halfLane, halfLane - halfCar })
        {
            plot.Add(new PlotLine("bound", [new Vector2D(0, bound), new Vector2D(way[^1], bound)]));
        }

        foreach (List<int> piece in Pieces(samples, sample => sample.IsByController && sample.Lane?.Lane is not null ? sample.Lane.Lane + (100 * sample.Lane.Road) : null))
        {
            plot.Add(new PlotLine(ByController, [.. piece.Select(i => new Vector2D(way[i], samples[i].Lane!.RightOfCentre))]));
        }

        return plot.ToSvg();
    }

    private static string Speed(IReadOnlyList<DriveSample> samples)
    {
        double[] way = Way(samples);
        Plot plot = Plot.Of("way, m", "speed, m/s", (0, way[^1]), (0, samples.Max(sample => sample.Speed)));
        AddByDriver(plot, samples, (sample, i) => new Vector2D(way[i], sample.Speed));
        return plot.ToSvg();
    }

    private static string JerkOf(IReadOnlyList<DriveSample> samples)
    {
        double[] way = Way(samples);
        (int Sample, double Jerk)[] jerks = [.. Jerk.Of(samples)];
        double most = jerks.Select(at => Math.Abs(at.Jerk)).Append(1).Max();
        Plot plot = Plot.Of("way, m", "jerk, m/s³", (0, way[^1]), (-most, most));
        foreach (IGrouping<int, (int Sample, double Jerk)> piece in jerks.Select((at, order) => (At: at, Piece: at.Sample - order)).GroupBy(at => at.Piece, at => at.At))
        {
            plot.Add(new PlotLine(ByController, [.. piece.Select(at => new Vector2D(way[at.Sample], at.Jerk))]));
        }

        return plot.ToSvg();
    }

    private static string Progress(IReadOnlyList<DriveSample> samples)
    {
        // Each start has a time of its own; the samples come at equal intervals.
        double[] way = Way(samples);
        double step = samples[1].TimeSeconds - samples[0].TimeSeconds;
        Plot plot = Plot.Of("time, s", "way, m", (0, step * (samples.Count - 1)), (0, way[^1]));
        AddByDriver(plot, samples, (_, i) => new Vector2D(step * i, way[i]));
        return plot.ToSvg();
    }

    private static void AddByDriver(Plot plot, IReadOnlyList<DriveSample> samples, Func<DriveSample, int, Vector2D> place)
    {
        foreach (List<int> piece in Pieces(samples, sample => sample.IsByController))
        {
            // A piece begins where the one before ended, so that there is no gap between them.
            IEnumerable<int> joined = piece[0] > 0 && !samples[piece[0]].IsTeleported ? piece.Prepend(piece[0] - 1) : piece;
            plot.Add(new PlotLine(samples[piece[0]].IsByController ? ByController : ByOwnDriver, [.. joined.Select(i => place(samples[i], i))]));
        }
    }

    /// <summary>Runs of samples of the same kind, none of which is null, cut where the car was put elsewhere.</summary>
    private static IEnumerable<List<int>> Pieces<T>(IReadOnlyList<DriveSample> samples, Func<DriveSample, T?> kindOf)
    {
        List<int> piece = [];
        for (int i = 0; i < samples.Count; i++)
        {
            T? kind = kindOf(samples[i]);
            if (piece.Count > 0 && (samples[i].IsTeleported || !Equals(kind, kindOf(samples[piece[0]]))))
            {
                yield return piece;
                piece = [];
            }

            if (kind is not null)
            {
                piece.Add(i);
            }
        }

        if (piece.Count > 0)
        {
            yield return piece;
        }
    }

    private static double[] Way(IReadOnlyList<DriveSample> samples)
    {
        double[] way = new double[samples.Count];
        for (int i = 1; i < way.Length; i++)
        {
            way[i] = way[i - 1] + (samples[i].IsTeleported ? 0 : (samples[i].Position - samples[i - 1].Position).Length);
        }

        return way;
    }
}
