using System.Collections.Generic;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Statistics;

/// <summary>What a session has of one class of objects.</summary>
public sealed class ClassStatistics
{
    private readonly HashSet<(int Session, int Id)> _ids = [];
    private readonly HashSet<(int Session, int Id)> _parts = [];
    private readonly QuantileSketch _distances = new();
    private double _occlusionSum;
    private int _occlusionCount;

    /// <summary>Labels: an object counts in each frame in which it is seen.</summary>
    public int Labels => _distances.Count;

    /// <summary>Different objects.</summary>
    public int Objects => _ids.Count;

    /// <summary>How many of them are parts of others: faces of signs, heads of lights.</summary>
    public int Parts => _parts.Count;

    /// <summary>Distance of the nearest, metres.</summary>
    public double MinMetres => _distances.Least;

    /// <summary>Median of the distances, metres, to 1/4096 of it: of an even number, the mean of the two in the middle.</summary>
    public double MedianDistanceMetres => _distances.Median;

    /// <summary>Mean of the occluded fractions, where they were determined; null where none was.</summary>
    public double? MeanOccludedFraction => _occlusionCount == 0 ? null : _occlusionSum / _occlusionCount;

    internal void Add(ObjectLabel label, int session)
    {
        _ids.Add((session, label.Id));
        if (label.Parent is not null)
        {
            _parts.Add((session, label.Id));
        }

        _distances.Add(label.DistanceMetres);
        if (label.OccludedFraction is { } occluded)
        {
            _occlusionSum += occluded;
            _occlusionCount++;
        }
    }
}
