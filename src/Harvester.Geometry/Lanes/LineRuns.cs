namespace Harvester.Geometry.Lanes;

/// <summary>Collects points into lines, one open run per number.</summary>
internal sealed class LineRuns
{
    private readonly List<LaneLine> _lines = [];
    private readonly Dictionary<int, (List<LinePoint> Points, bool IsLeft)> _open = [];

    /// <summary>Continues the run of a number, or begins one.</summary>
    public void Add(int index, bool isLeftOfCar, LinePoint point)
    {
        if (!_open.TryGetValue(index, out (List<LinePoint> Points, bool IsLeft) run))
        {
            run = ([], isLeftOfCar);
            _open.Add(index, run);
        }

        run.Points.Add(point);
    }

    /// <summary>Ends the runs of all other numbers; a single point does not make a line.</summary>
    public void EndAllBut(IEnumerable<int> going)
    {
        // Copied first, because runs are removed on the way.
        foreach (int index in _open.Keys.Except(going).ToList())
        {
            if (_open[index].Points.Count > 1)
            {
                _lines.Add(new LaneLine(index, _open[index].IsLeft, _open[index].Points));
            }

            _open.Remove(index);
        }
    }

    /// <summary>Ends all open runs and returns all lines, in the order of their numbers.</summary>
    public IReadOnlyList<LaneLine> Lines()
    {
        EndAllBut([]);
        return [.. _lines.OrderBy(line => line.Index)];
    }
}
