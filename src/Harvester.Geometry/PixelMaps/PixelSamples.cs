using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>What rays have told of an image so far. Each place is asked once; the answers are shared by all who need them.</summary>
internal sealed class PixelSamples
{
    /// <summary>Places between pixel centres are told apart by eighths of a pixel.</summary>
    public const int Fine = 8;

    private const int Unknown = -1;
    private readonly Camera _camera;
    private readonly IRayCaster _rays;
    private readonly int _ignoredEntity;
    private readonly Dictionary<int, ushort> _numbers = [];
    private readonly int[] _known;
    private readonly float[] _distances;
    private readonly bool[] _assumed;
    private readonly Dictionary<long, int> _between = [];
    private readonly HashSet<int> _met = [];

    public PixelSamples(Camera camera, IReadOnlyList<MapTarget> targets, int ignoredEntity, IRayCaster rays)
    {
        _camera = camera;
        _rays = rays;
        _ignoredEntity = ignoredEntity;
        _known = new int[camera.Image.PixelCount];
        _distances = new float[_known.Length];
        _assumed = new bool[_known.Length];
        foreach (MapTarget target in targets)
        {
            _numbers[target.Entity] = target.Number;
        }
    }

    public int RaysCast { get; private set; }

    /// <summary>Whether any ray has met the object with a number.</summary>
    public bool HasMet(int number) => _met.Contains(number);

    /// <summary>The number of pixels through whose centres a ray was cast.</summary>
    public int PixelsCast { get; private set; }

    /// <summary>Lets the pixels of a silhouette's box be asked; all others are known to show nothing.</summary>
    /// <returns>The number of pixels that could not be asked before.</returns>
    public int Open(SilhouetteSpans spans)
    {
        int opened = 0;
        for (int row = spans.FirstRow; row <= spans.LastRow; row++)
        {
            for (int index = Index(spans.FirstColumn, row); index <= Index(spans.LastColumn, row); index++)
            {
                opened += _known[index] == Unknown ? 0 : 1;
                _known[index] = Unknown;
            }
        }

        return opened;
    }

    /// <summary>Whether a pixel's number is known or taken for known.</summary>
    public bool IsKnown(int column, int row) => _known[Index(column, row)] != Unknown;

    /// <summary>Whether a ray was cast through this pixel's centre.</summary>
    public bool IsCast(int column, int row) => HasDistance(column, row) && !IsAssumed(column, row);

    /// <summary>Whether the distance at this pixel is known or taken for known.</summary>
    public bool HasDistance(int column, int row) => _distances[Index(column, row)] > 0;

    /// <summary>Whether a pixel's number is taken from those around it, until it is asked.</summary>
    public bool IsAssumed(int column, int row) => _assumed[Index(column, row)];

    /// <summary>Whether a ray through this pixel's centre would tell something new.</summary>
    public bool IsUnasked(int column, int row) => !IsKnown(column, row) || IsAssumed(column, row);

    public bool IsUnasked(Place pixel) => IsUnasked(pixel.FineX / Fine, pixel.FineY / Fine);

    /// <summary>
    /// Takes the number of a pixel that is not known from those around it, and the distance, metres; 0 when that is not known.
    /// </summary>
    public void Assume(int column, int row, int number, float distance = 0)
    {
        _distances[Index(column, row)] = distance;
        _known[Index(column, row)] = number;
        _assumed[Index(column, row)] = true;
    }

    public int Number(int column, int row) => _known[Index(column, row)];

    /// <summary>The distance at a pixel, metres; infinite where there is nothing or it is not known.</summary>
    public float Distance(int column, int row)
    {
        float distance = _distances[Index(column, row)];
        return distance > 0 ? distance : float.PositiveInfinity;
    }

    public int? NumberBetween(Place place) => _between.TryGetValue(Key(place), out int number) ? number : null;

    public void Cast(Place place)
    {
        RayHit? hit = _rays.Cast(
            _camera.RayThrough(((double)place.FineX / Fine) + 0.5, ((double)place.FineY / Fine) + 0.5),
            ExhaustivePixelMapper.RayLength,
            _ignoredEntity);
        RaysCast++;
        int number = hit is { Entity: not RayHit.World } seen && _numbers.TryGetValue(seen.Entity, out ushort own) ? own : 0;
        _met.Add(number);
        if (place.FineX % Fine == 0 && place.FineY % Fine == 0)
        {
            int index = Index(place.FineX / Fine, place.FineY / Fine);
            _known[index] = number;
            _assumed[index] = false;
            PixelsCast++;
            _distances[index] = hit is { } at ? Math.Max((float)at.Distance, float.Epsilon) : float.PositiveInfinity;
        }
        else
        {
            _between[Key(place)] = number;
        }
    }

    private static long Key(Place place) => ((long)place.FineY << 32) | (uint)place.FineX;

    private int Index(int column, int row) => (row * _camera.Image.Width) + column;
}
