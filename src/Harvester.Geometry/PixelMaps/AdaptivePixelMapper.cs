using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Algorithm 4 with few rays: all entities in one pass, within their boxes. Changes along a cell's border are found by bisection. Its
/// inside is assumed to show straight outlines between these changes, which rays on both sides of the middle of each outline confirm. A
/// cell that is not confirmed is divided, those first whose error matters most for an object's visible pixels. The result does not depend
/// on the order of the targets. The work can be stopped after any ray and gives the best map so far. See docs/pixel-maps.md.
/// </summary>
public sealed class AdaptivePixelMapper
{
    /// <summary>Number of searches for parts that the map misses; what one search finds shows the next where to look closer.</summary>
    private const int FragmentSearches = 2;

    /// <summary>
    /// Number of searches: after those for missed parts and for the ends of objects, five that divide cells at these ends, from the usual
    /// first cell of 32 = 2^5 pixels down to the pixel.
    /// </summary>
    private const int MaxSearches = FragmentSearches + 1 + 5;

    private readonly Camera _camera;
    private readonly PixelMapOptions _options;
    private readonly int _ignoredEntity;
    private readonly IRayCaster _rays;
    private readonly List<MapTarget> _targets;
    private readonly List<MapTarget> _beyondReach = [];
    private readonly List<TargetView> _views = [];
    private readonly PixelSamples _samples;
    private readonly CellExaminer _examiner;
    private readonly CellQueue _queue = new();
    private readonly SettledCells _settled;
    private readonly MapPainter _painter;

    /// <summary>The map that the searches look at.</summary>
    private readonly InstanceMap _map;
    private readonly FragmentSearch _search;
    private readonly ExtentSearch _extents;
    private IEnumerator<SubpixelPoint> _places;
    private int _openPixels;
    private MapCell? _current;
    private MapperPhase _phase = MapperPhase.SeedSamples;
    private UnseenTargets? _unseen;
    private int _searches;

    /// <summary>Starts a map. No ray is cast before the first <see cref="Step"/>.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="targets">The entities to show, in any order, each with a handle and a number of its own.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through; <see cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster.</param>
    /// <param name="options">Maximum cost and requested accuracy.</param>
    /// <exception cref="ArgumentException">Two targets have the same number or handle, or a number is 0.</exception>
    /// <exception cref="ArgumentOutOfRangeException">An option is out of its range.</exception>
    public AdaptivePixelMapper(Camera camera, IReadOnlyList<MapTarget> targets, int ignoredEntity, IRayCaster rays, PixelMapOptions options)
    {
        _camera = Guard.NotNull(camera, nameof(camera));
        _options = Guard.NotNull(options, nameof(options)).Checked();
        _targets = TargetOrder.ByNumber(Guard.NotNull(targets, nameof(targets)));
        _ignoredEntity = ignoredEntity;
        _rays = Guard.NotNull(rays, nameof(rays));
        foreach (MapTarget target in _targets)
        {
            if (SilhouettePainter.DistanceOf(camera, target) - target.Cuboid.HalfExtents.Length > _options.RayReachMetres)
            {
                _beyondReach.Add(target);
            }
            else if (target.Projection.Box is { } box)
            {
                _views.Add(new TargetView(target, new SilhouetteSpans(target.Projection.Silhouette, box, camera.Image)));
            }
        }

        _samples = new PixelSamples(camera, _views.ConvertAll(view => view.Target), ignoredEntity, rays);
        _views.ForEach(view => _openPixels += _samples.Open(view.Spans));
        var hidden = new HiddenPlaces(camera, _samples);
        _search = new FragmentSearch(camera.Image, _views, _samples, hidden, _options.UnsearchedFraction);
        _extents = new ExtentSearch(_views, _samples, hidden);
        _examiner = new CellExaminer(_samples, _views, _options);
        _painter = new MapPainter(camera, _samples, _examiner, _views);
        _map = new InstanceMap(camera.Image);
        _settled = new SettledCells(_examiner, _samples.Changes, _queue, _options.CellErrorFraction);
        var grid = new CellGrid(camera.Image, _options.CellSize, _views);
        grid.Cells.ForEach(cell => _queue.Add(double.PositiveInfinity, cell));
        _places = new SeedSamples(camera, _views, _samples, grid).InTurn().GetEnumerator();
    }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast => _samples.RaysCast + (_unseen?.RaysCast ?? 0);

    /// <summary>Whether the map has the accuracy that the options request.</summary>
    public bool IsComplete => _phase == MapperPhase.Complete;

    /// <summary>Continues until the map is complete, the ray budget is spent, or the time is up.</summary>
    /// <param name="isTimeUp">Called after every ray; null for no time limit.</param>
    /// <returns>Whether the work is over: the map is complete, or the ray budget spent.</returns>
    public bool Run(Func<bool>? isTimeUp = null)
    {
        while (Step())
        {
            if (isTimeUp is not null && isTimeUp())
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Casts one ray.</summary>
    /// <returns>False if no ray is left to cast: the map is complete or the ray budget is spent.</returns>
    public bool Step()
    {
        if (IsComplete || RaysCast >= _options.RayBudget)
        {
            return false;
        }

        if (_phase != MapperPhase.Probes)
        {
            if (NextPlace() is { } place)
            {
                _samples.Cast(place);
                return true;
            }

            _phase = MapperPhase.Probes;
            _unseen = new UnseenTargets(_camera, _views, _samples, PixelCounts(Paint()), _ignoredEntity, _rays);
        }

        if (_unseen!.Step())
        {
            return true;
        }

        _phase = MapperPhase.Complete;
        return false;
    }

    /// <summary>The best map so far. It may be requested at any time, and the work may continue after it.</summary>
    public AdaptivePixelMap Finish()
    {
        var map = new InstanceMap(_camera.Image);
        PaintInto(map);
        Evidence.Demand(map, _samples, _targets, GreatestNumber);
        int resolution = 1;
        foreach ((_, MapCell cell) in Pending())
        {
            resolution = Math.Max(resolution, Math.Max(cell.Width, cell.Height));
        }

        return new AdaptivePixelMap(map, RaysCast, IsComplete, resolution, _openPixels - _samples.PixelsCast, SightsIn(map));
    }

    private Dictionary<ushort, Sight> SightsIn(InstanceMap map)
    {
        var sights = new Dictionary<ushort, Sight>();
        _targets.ForEach(target => sights[target.Number] = _unseen?.SightOf(target.Number) ?? Sight.NotAsked);
        _beyondReach.ForEach(target => sights[target.Number] = Sight.Undetermined);
        int[] counts = PixelCounts(map);
        for (int number = 1; number < counts.Length; number++)
        {
            if (counts[number] > 0)
            {
                sights[(ushort)number] = Sight.Seen;
            }
        }

        return sights;
    }

    private SubpixelPoint? NextPlace()
    {
        do
        {
            while (_places.MoveNext())
            {
                if (_samples.IsUnsampled(_places.Current))
                {
                    return _places.Current;
                }
            }

            if (_phase == MapperPhase.SeedSamples)
            {
                _views.ForEach(view => view.EstimateVisible(_samples));
                _phase = MapperPhase.Cells;
            }

            if (NextPlaceOfCells() is { } wanted)
            {
                return wanted;
            }
        } while (Search());
        return null;
    }

    private SubpixelPoint? NextPlaceOfCells()
    {
        while (_current is not null || _queue.Count > 0 || _settled.Review())
        {
            if (_current is not { } cell)
            {
                (double priority, cell) = _queue.Take();
                if (priority < _options.CellErrorFraction)
                {
                    _settled.AddSmall(cell);
                    continue;
                }

                _current = cell;
            }

            if (_examiner.WantedOnBorder(cell) is { } onBorder)
            {
                return onBorder;
            }

            CellVerdict verdict = _examiner.ExamineInside(cell);
            if (verdict.Wanted is { } wanted)
            {
                return wanted;
            }

            _current = null;
            if (verdict.IsResolved)
            {
                _settled.AddUnderstood(cell);
            }
            else
            {
                _examiner.Border.AssumeMiddles();
                foreach (MapCell part in cell.Quarters())
                {
                    _queue.Add(CellQueue.PriorityOf(part, verdict.Weight), part);
                }
            }
        }

        return null;
    }

    // A search that finds nothing is followed by a review too, since the visible pixels have been counted again.
    private bool Search()
    {
        if (_searches == MaxSearches)
        {
            return false;
        }

        _searches++;
        InstanceMap map = Paint();

        // First missed parts, with the visible pixels counted in the map, which changes the weights of all cells.
        if (_searches <= FragmentSearches)
        {
            int[] counts = PixelCounts(map);
            _views.ForEach(view => view.SetVisible(counts[view.Target.Number]));
            _settled.Invalidate();
            List<SubpixelPoint> places = [.. _search.Places(map)];
            _places = places.GetEnumerator();
            return true;
        }

        // Then the sides of the objects' boxes.
        if (_searches == FragmentSearches + 1)
        {
            _places = _extents.Places(map).GetEnumerator();
            return true;
        }

        // Last, cells at sides that no ray has confirmed are divided down to the pixel, a level each time.
        return _settled.Reopen(_extents.UncertainPixels(map));
    }

    // The targets are sorted by number.
    private int GreatestNumber => _targets.Count == 0 ? 0 : _targets[_targets.Count - 1].Number;

    private int[] PixelCounts(InstanceMap map) => map.PixelCounts(GreatestNumber);

    private InstanceMap Paint()
    {
        Array.Clear(_map.Ids, 0, _map.Ids.Length);
        PaintInto(_map);
        return _map;
    }

    private void PaintInto(InstanceMap map)
    {
        var untouched = new List<MapCell>();
        var touched = new List<MapCell>(_settled.Cells);
        foreach ((double priority, MapCell cell) in Pending())
        {
            (double.IsInfinity(priority) ? untouched : touched).Add(cell);
        }

        _painter.Paint(map, untouched, touched);
    }

    private IEnumerable<(double Priority, MapCell Cell)> Pending()
    {
        if (_current is { } current)
        {
            yield return (0, current);
        }

        foreach ((double Priority, MapCell Cell) entry in _queue.Cells)
        {
            yield return entry;
        }
    }
}
