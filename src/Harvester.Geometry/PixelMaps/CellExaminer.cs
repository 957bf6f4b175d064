using System;
using System.Collections.Generic;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Decides about a cell from what is known: which place to ask next, or that it is understood, or that it must be divided. It keeps
/// nothing of its own, so that a cell can be looked at again whenever its neighbours have learnt more.
/// </summary>
internal sealed class CellExaminer
{
    /// <summary>A cell whose border shows more runs than this is divided at once.</summary>
    private const int MaxRuns = 8;

    /// <summary>The mean distance, in pixels, of a line between two changes known to the pixel from the true one.</summary>
    private const double MeanLineError = 0.2;
    private const int MaxHalvings = 3;

    /// <summary>A chord that runs along a row or column to within this many pixels gains nothing from knowing its ends better.</summary>
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

    /// <summary>The border of the cell that was looked at last.</summary>
    public CellBorder Border => _border;

    public CellVerdict Examine(MapCell cell)
    {
        _border.Read(cell);
        Place? onBorder = _border.Wanted();
        double weight = Weight(cell);
        if (onBorder is { } unknown)
        {
            return CellVerdict.Ask(unknown, weight);
        }

        if (!cell.HasInterior)
        {
            return CellVerdict.Understood(weight);
        }

        if (_border.Runs.Count <= MaxRuns && StripSearch.Wanted(_border, _samples) is { } towards)
        {
            return CellVerdict.Ask(towards, weight);
        }

        bool outlineTooLong = _border.Runs.Count > 1 && cell.Width * cell.Height * weight > _options.StraightCellFraction;
        if (outlineTooLong || _border.Runs.Count > MaxRuns)
        {
            return CellVerdict.Divide(weight);
        }

        int halvings = Halvings(cell, weight);
        return AgreeingModel(halvings) is { } model
            ? Missing(model, halvings) is { } place ? CellVerdict.Ask(place, weight) : CellVerdict.Understood(weight)
            : CellVerdict.Divide(weight);
    }

    /// <summary>The simplest picture of the inside of the border's cell that fits all that is known, or null.</summary>
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
            for (int column = cell.Left + 1; column < cell.Right; column++)
            {
                if (_samples.IsCast(column, row))
                {
                    weight = Math.Max(weight, WeightOf(_samples.Number(column, row)));
                }
            }
        }

        return weight;
    }

    private double WeightOf(int number) => _byNumber.TryGetValue(number, out TargetView view) ? view.Weight : 0;

    private int Halvings(MapCell cell, double weight)
    {
        int halvings = 0;
        double error = MeanLineError * Math.Max(cell.Width, cell.Height) * weight;
        while (halvings < MaxHalvings && error > _options.CellErrorFraction)
        {
            halvings++;
            error /= 2;
        }

        return halvings;
    }

    private Place? Missing(CellModel model, int halvings)
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
                return Place.OfPixel(column, row);
            }
        }

        return null;
    }

    private List<int> NumbersByDistance()
    {
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

        nearest.Sort();
        return nearest.ConvertAll(entry => entry.Number);
    }

    private bool Agrees(CellModel model)
    {
        MapCell cell = _border.Cell;
        for (int row = cell.Top + 1; row < cell.Bottom; row++)
        {
            for (int column = cell.Left + 1; column < cell.Right; column++)
            {
                if (_samples.IsCast(column, row) && model.NumberAt(column, row) != _samples.Number(column, row))
                {
                    return false;
                }
            }
        }

        return true;
    }
}
