using Harvester.Geometry;
using Harvester.Pages.Plots;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Evaluation.Reports;

/// <summary>The plots of a drive with at least two samples.</summary>
internal sealed class DrivePlots
{
    public const string ByController = "controller";
    public const string ByBuiltInDriver = "builtin";
    public const string Departure = "departure";
    public const string Collision = "collision";

    private const double HalfLaneMetres = 2.7;
    private const double HalfCarMetres = 1.02;
    private const int LanesPerRoad = 100;
    private const string DistanceDriven = "distance driven, m";

    private readonly IReadOnlyList<DriveSample> _samples;
    private readonly double[] _distances;

    public DrivePlots(IReadOnlyList<DriveSample> samples)
    {
        _samples = samples;
        _distances = new double[samples.Count];
        for (int i = 1; i < _distances.Length; i++)
        {
            _distances[i] = _distances[i - 1] + (samples[i].IsTeleported ? 0 : (samples[i].Position - samples[i - 1].Position).Length);
        }
    }

    private double Length => _distances[^1];

    /// <summary>The path of the car, with rings around events.</summary>
    public LinePlot Map(IEnumerable<DriveEvent> departures, IEnumerable<DriveEvent> collisions)
    {
        LinePlot map = LinePlot.Map(_samples.Select(sample => sample.Position));
        AddByDriver(map, i => _samples[i].Position);
        foreach (DriveEvent departure in departures)
        {
            map.Add(new PlotMark(Departure, departure.Place, departure.Description));
        }

        foreach (DriveEvent collision in collisions)
        {
            map.Add(new PlotMark(Collision, collision.Place, collision.Description));
        }

        return map;
    }

    public LinePlot LateralError()
    {
        LinePlot plot = OverDistance("right of the lane centre, m", -HalfLaneMetres, HalfLaneMetres);
        foreach (double bound in new[] { HalfCarMetres - HalfLaneMetres, HalfLaneMetres - HalfCarMetres })
        {
            plot.Add(new PlotLine("bound", [new Vector2D(0, bound), new Vector2D(Length, bound)]));
        }

        foreach (
            List<int> piece in Pieces<int>(sample =>
                sample.IsByController && sample.Lane?.Lane is { } lane ? lane + (LanesPerRoad * sample.Lane.Road) : null
            )
        )
        {
            plot.Add(new PlotLine(ByController, [.. piece.Select(i => new Vector2D(_distances[i], _samples[i].Lane!.RightOfCentre))]));
        }

        return plot;
    }

    public LinePlot Speed()
    {
        LinePlot plot = OverDistance("speed, m/s", 0, _samples.Max(sample => sample.Speed));
        AddByDriver(plot, i => new Vector2D(_distances[i], _samples[i].Speed));
        return plot;
    }

    public LinePlot Jerk()
    {
        (int Sample, double Jerk)[] jerks = [.. Harvester.Runs.Evaluation.Figures.Jerk.Of(_samples)];
        double max = jerks.Select(at => Math.Abs(at.Jerk)).Append(1).Max();
        LinePlot plot = OverDistance("jerk, m/s³", -max, max);
        foreach (
            IGrouping<int, (int Sample, double Jerk)> piece in jerks
                .Select((at, order) => (At: at, Piece: at.Sample - order))
                .GroupBy(at => at.Piece, at => at.At)
        )
        {
            plot.Add(new PlotLine(ByController, [.. piece.Select(at => new Vector2D(_distances[at.Sample], at.Jerk))]));
        }

        return plot;
    }

    public LinePlot Progress()
    {
        // Each start has its own time; the samples have equal intervals.
        double step = _samples[1].TimeSeconds - _samples[0].TimeSeconds;
        var plot = new LinePlot(PlotAxis.Around("time, s", 0, step * (_samples.Count - 1)), PlotAxis.Around(DistanceDriven, 0, Length));
        AddByDriver(plot, i => new Vector2D(step * i, _distances[i]));
        return plot;
    }

    private LinePlot OverDistance(string name, double min, double max) =>
        new(PlotAxis.Around(DistanceDriven, 0, Length), PlotAxis.Around(name, min, max));

    private void AddByDriver(LinePlot plot, Func<int, Vector2D> place)
    {
        foreach (List<int> piece in Pieces<bool>(sample => sample.IsByController))
        {
            // A piece begins where the previous one ends, so that there is no gap.
            IEnumerable<int> joined = piece[0] > 0 && !_samples[piece[0]].IsTeleported ? piece.Prepend(piece[0] - 1) : piece;
            plot.Add(new PlotLine(_samples[piece[0]].IsByController ? ByController : ByBuiltInDriver, [.. joined.Select(place)]));
        }
    }

    /// <summary>Runs of samples of the same kind, split where the car was repositioned; samples without a kind are in none.</summary>
    private IEnumerable<List<int>> Pieces<T>(Func<DriveSample, T?> kindOf)
        where T : struct
    {
        List<int> piece = [];
        for (int i = 0; i < _samples.Count; i++)
        {
            T? kind = kindOf(_samples[i]);
            if (piece.Count > 0 && (_samples[i].IsTeleported || !Equals(kind, kindOf(_samples[piece[0]]))))
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
}
