using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>The samples of an image so far. Each point is sampled once; all users share the results.</summary>
internal sealed class PixelSamples
{
    /// <summary>Points between pixel centres are distinguished by eighths of a pixel.</summary>
    public const int Fine = 8;

    /// <summary>The number of a pixel that is neither known nor taken for known.</summary>
    public const int Unknown = -1;

    /// <summary>Samples are few: runs of pixels without one are skipped.</summary>
    private const int RunLength = 8;

    private readonly Camera _camera;
    private readonly int _width;
    private readonly IRayCaster _rays;
    private readonly int _ignoredEntity;
    private readonly Dictionary<int, ushort> _numbers = [];
    private readonly int[] _known;
    private readonly float[] _distances;
    private readonly bool[] _assumed;

    /// <summary>For each run of <see cref="RunLength"/> pixels of a row whether the distance of any of them is known or assumed.</summary>
    private readonly bool[] _runs;
    private readonly int _runsAcross;
    private readonly Dictionary<long, int> _between = [];
    private readonly HashSet<int> _met = [];

    public PixelSamples(Camera camera, IReadOnlyList<MapTarget> targets, int ignoredEntity, IRayCaster rays)
    {
        _camera = camera;
        _width = camera.Image.Width;
        _rays = rays;
        _ignoredEntity = ignoredEntity;
        _known = new int[camera.Image.PixelCount];
        _distances = new float[_known.Length];
        _assumed = new bool[_known.Length];
        _runsAcross = (camera.Image.Width + RunLength - 1) / RunLength;
        _runs = new bool[_runsAcross * camera.Image.Height];
        Changes = new ChangeStamps(camera.Image);
        foreach (MapTarget target in targets)
        {
            _numbers[target.Entity] = target.Number;
        }
    }

    public int RaysCast { get; private set; }

    /// <summary>When what is known, or taken for known, last changed.</summary>
    public ChangeStamps Changes { get; }

    /// <summary>Whether any ray has met the object with a number.</summary>
    public bool HasMet(int number) => _met.Contains(number);

    /// <summary>The number of pixels through whose centres a ray was cast.</summary>
    public int PixelsCast { get; private set; }

    /// <summary>Allows sampling the pixels of a silhouette's box; all others are known to show nothing.</summary>
    /// <returns>The number of pixels that could not be sampled before.</returns>
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

    /// <summary>Whether a pixel's number is known or assumed.</summary>
    public bool IsKnown(int column, int row) => _known[Index(column, row)] != Unknown;

    /// <summary>
    /// Whether all distances that are known in a rectangle, both ends included, at pixels of a number are at most so great.
    /// </summary>
    /// <returns>Null where none is known.</returns>
    public bool? AreWithin(double distance, int number, (int Left, int Top, int Right, int Bottom) rectangle)
    {
        bool? areWithin = null;
        for (int row = rectangle.Top; row <= rectangle.Bottom; row++)
        {
            int column = rectangle.Left;
            while ((column = NextInSampledRun(column, rectangle.Right + 1, row)) <= rectangle.Right)
            {
                int i = Index(column++, row);
                if (_distances[i] > 0 && _known[i] == number)
                {
                    if (_distances[i] > distance)
                    {
                        return false;
                    }

                    areWithin = true;
                }
            }
        }

        return areWithin;
    }

    /// <summary>Whether a ray was cast through this pixel's centre.</summary>
    public bool IsCast(int column, int row)
    {
        int index = Index(column, row);
        return _distances[index] > 0 && !_assumed[index];
    }

    /// <summary>The first sampled column of a row, from a given column to an end; the end if there is none.</summary>
    public int NextCast(int column, int end, int row)
    {
        while ((column = NextInSampledRun(column, end, row)) < end && !IsCast(column, row))
        {
            column++;
        }

        return column;
    }

    /// <summary>Whether the distance at this pixel is known or assumed.</summary>
    public bool HasDistance(int column, int row) => _distances[Index(column, row)] > 0;

    /// <summary>Whether a pixel's number is assumed from its surroundings, until it is sampled.</summary>
    public bool IsAssumed(int column, int row) => _assumed[Index(column, row)];

    /// <summary>Whether a ray through this pixel's centre would give new information.</summary>
    public bool IsUnsampled(int column, int row) => !IsKnown(column, row) || IsAssumed(column, row);

    public bool IsUnsampled(SubpixelPoint pixel) => IsUnsampled(pixel.FineX / Fine, pixel.FineY / Fine);

    /// <summary>Assumes the number of an unknown pixel from its surroundings, and the distance, metres; 0 if that is unknown.</summary>
    public void Assume(int column, int row, int number, float distance = 0)
    {
        Changes.Change(column, row);
        SetDistance(column, row, distance);
        _known[Index(column, row)] = number;
        _assumed[Index(column, row)] = true;
    }

    /// <summary>A pixel's number; <see cref="Unknown"/> where it is not known.</summary>
    public int Number(int column, int row) => _known[Index(column, row)];

    /// <summary>The distance at a pixel, metres; infinite if nothing was hit or it is unknown.</summary>
    public float Distance(int column, int row)
    {
        float distance = _distances[Index(column, row)];
        return distance > 0 ? distance : float.PositiveInfinity;
    }

    public int? NumberBetween(SubpixelPoint place) => _between.TryGetValue(Key(place), out int number) ? number : null;

    public void Cast(SubpixelPoint place)
    {
        RayHit? hit = _rays.Cast(
            _camera.RayThrough(((double)place.FineX / Fine) + 0.5, ((double)place.FineY / Fine) + 0.5),
            ExhaustivePixelMapper.RayLength,
            _ignoredEntity
        );
        RaysCast++;
        int number = hit is { Entity: not RayHit.World } seen && _numbers.TryGetValue(seen.Entity, out ushort own) ? own : 0;
        _met.Add(number);

        // A place between two pixels is on the borders of cells that have both.
        Changes.Change(place.FineX / Fine, place.FineY / Fine);
        if (place.FineX % Fine == 0 && place.FineY % Fine == 0)
        {
            (int column, int row) = (place.FineX / Fine, place.FineY / Fine);
            int index = Index(column, row);
            _known[index] = number;
            _assumed[index] = false;
            PixelsCast++;
            SetDistance(column, row, hit is { } at ? Math.Max((float)at.Distance, float.Epsilon) : float.PositiveInfinity);
        }
        else
        {
            _between[Key(place)] = number;
        }
    }

    private static long Key(SubpixelPoint place) => ((long)place.FineY << 32) | (uint)place.FineX;

    private int NextInSampledRun(int column, int end, int row)
    {
        while (column < end && !_runs[(row * _runsAcross) + (column / RunLength)])
        {
            column = ((column / RunLength) + 1) * RunLength;
        }

        return Math.Min(column, end);
    }

    private void SetDistance(int column, int row, float distance)
    {
        _distances[Index(column, row)] = distance;
        _runs[(row * _runsAcross) + (column / RunLength)] = true;
    }

    private int Index(int column, int row) => (row * _width) + column;
}
