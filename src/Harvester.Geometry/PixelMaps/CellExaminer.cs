namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Decides what to do with a cell: which point to sample next, whether it is resolved, or whether to divide it. It keeps no state, so a
/// cell can be examined again whenever its neighbours have new samples.
/// </summary>
internal sealed class CellExaminer
{
    /// <summary>A cell whose border shows more runs than this is divided at once.</summary>
    private const int MaxRuns = 8;

    /// <summary>
    /// The mean distance, in pixels, between the true outline and a line between two changes that are known to the pixel. With errors u and
    /// v of the ends, uniform in ±½, it is the mean of |(1 - t) u + t v| over the line, 0.199.
    /// </summary>
    private const double MeanLineError = 0.2;
    private const int MaxHalvings = 3;

    /// <summary>A chord that runs along a row or column to within this many pixels is not improved by locating its ends better.</summary>
    private const double AlignedPixels = 0.9;

    private readonly PixelSamples _samples;
    private readonly PixelMapOptions _options;
    private readonly Dictionary<int, TargetView> _byNumber = [];
    private readonly CellBorder _border;

    public CellExaminer(PixelSamples samples, IReadOnlyList<TargetView> views, PixelMapOptions options)
    {
        _samples = samples;
        _options = options;
        var spans = new List<SilhouetteSpans>();
        foreach (TargetView view in views)
        {
            _byNumber[view.Target.Number] = view;
            spans.Add(view.Spans);
        }

        _border = new CellBorder(samples, spans);
    }

    /// <summary>The border of the cell examined last.</summary>
    public CellBorder Border => _border;

    /// <summary>The place that the border of a cell asks for before its inside is looked at, or null.</summary>
    public SubpixelPoint? WantedOnBorder(MapCell cell)
    {
        _border.Read(cell);
        return _border.Wanted();
    }

    public CellVerdict Examine(MapCell cell)
    {
        SubpixelPoint? onBorder = WantedOnBorder(cell);
        double weight = Weight(cell);
        return onBorder is { } unknown ? CellVerdict.Sample(unknown, weight) : ExamineInside(cell, weight);
    }

    /// <summary>Decides about the inside of a cell whose border asks for nothing; it must be the one that was looked at last.</summary>
    public CellVerdict ExamineInside(MapCell cell) => ExamineInside(cell, Weight(cell));

    private CellVerdict ExamineInside(MapCell cell, double weight)
    {
        if (!cell.HasInterior)
        {
            return CellVerdict.Resolved(weight);
        }

        if (_border.Runs.Count <= MaxRuns && StripSearch.Wanted(_border, _samples) is { } towards)
        {
            return CellVerdict.Sample(towards, weight);
        }

        // Area times the weight of a pixel: the largest part of an object that one cell may take on trust.
        bool outlineTooLong = _border.Runs.Count > 1 && cell.Width * cell.Height * weight > _options.StraightCellFraction;
        if (outlineTooLong || _border.Runs.Count > MaxRuns)
        {
            return CellVerdict.Divide(weight);
        }

        int halvings = Halvings(cell, weight);
        return AgreeingModel(halvings) is { } model
            ? Missing(model, halvings) is { } place
                ? CellVerdict.Sample(place, weight)
                : CellVerdict.Resolved(weight)
            : CellVerdict.Divide(weight);
    }

    /// <summary>The simplest model of the inside of the border's cell that fits all samples, or null.</summary>
    public CellModel? AgreeingModel(int halvings = MaxHalvings)
    {
        foreach (int front in NumbersByDistance())
        {
            if (CellModel.Build(_border, front, step => _border.Crossing(step, halvings)) is { } model && Agrees(model))
            {
                return model;
            }
        }

        return null;
    }

    private double Weight(MapCell cell)
    {
        _border.CollectRuns();
        double weight = 0;
        foreach (BorderRun run in _border.Runs)
        {
            weight = Math.Max(weight, WeightOf(run.Number));
        }

        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; (column = _samples.NextCast(column, cell.Right, row)) < cell.Right; column++)
            {
                if (_samples.Number(column, row) is var number && number != 0)
                {
                    weight = Math.Max(weight, WeightOf(number));
                }
            }
        }

        return weight;
    }

    private double WeightOf(int number) => _byNumber.TryGetValue(number, out TargetView? view) ? view.Weight : 0;

    private int Halvings(MapCell cell, double weight)
    {
        int halvings = 0;

        // Wrong area = mean distance × length of the outline, as a fraction of the visible pixels of the object that counts most. Each
        // halving of the interval at both ends halves it.
        double error = MeanLineError * Math.Max(cell.Width, cell.Height) * weight;
        while (halvings < MaxHalvings && error > _options.CellErrorFraction)
        {
            halvings++;
            error /= 2;
        }

        return halvings;
    }

    private SubpixelPoint? Missing(CellModel model, int halvings)
    {
        if (!model.IsAligned(AlignedPixels))
        {
            foreach (BorderRun run in _border.Runs)
            {
                if (_border.WantedBetween(run.End, halvings) is { } between)
                {
                    return between;
                }
            }
        }

        MapCell cell = _border.Cell;
        foreach ((int column, int row) in model.Tests())
        {
            if (column > cell.Left && column < cell.Right && row > cell.Top && row < cell.Bottom && !_samples.IsKnown(column, row))
            {
                return SubpixelPoint.OfPixel(column, row);
            }
        }

        return null;
    }

    private List<int> NumbersByDistance()
    {
        if (_border.Runs.Count == 1)
        {
            return [_border.Runs[0].Number];
        }

        var nearest = new List<(float Distance, int Number)>();
        foreach (BorderRun run in _border.Runs)
        {
            float distance = float.PositiveInfinity;
            for (int i = run.Start; i <= run.End; i++)
            {
                (int column, int row) = _border.Cell.Border(i % _border.Cell.BorderLength);
                if (_samples.IsCast(column, row))
                {
                    distance = Math.Min(distance, _samples.Distance(column, row));
                }
            }

            int at = nearest.FindIndex(entry => entry.Number == run.Number);
            if (at < 0)
            {
                nearest.Add((distance, run.Number));
            }
            else
            {
                nearest[at] = (Math.Min(distance, nearest[at].Distance), run.Number);
            }
        }

        // The nearest object is the likeliest to be in front, and its model is tried first; equal distances go by number.
        nearest.Sort();
        return nearest.ConvertAll(entry => entry.Number);
    }

    private bool Agrees(CellModel model)
    {
        MapCell cell = _border.Cell;
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; (column = _samples.NextCast(column, cell.Right, row)) < cell.Right; column++)
            {
                if (model.NumberAt(column, row) != _samples.Number(column, row))
                {
                    return false;
                }
            }
        }

        return true;
    }
}
