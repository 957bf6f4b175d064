using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>What is found of one frame while it is labelled.</summary>
internal sealed class FrameFindings
{
    private readonly List<ObjectLabel> _objects = [];
    private readonly List<IgnoreRegion> _regions = [];
    private readonly List<RecordedOcclusion> _occlusions = [];
    private readonly List<DistantEntity> _distant = [];
    private readonly Dictionary<int, OcclusionEstimate> _entities = [];

    /// <summary>The instance map; null until there is one.</summary>
    public InstanceMap? Mask { get; set; }

    /// <summary>How well the mask is known; null without one.</summary>
    public PixelMapLabel? PixelMap { get; set; }

    /// <summary>The lanes; null when no roads are known.</summary>
    public LanesLabel? Lanes { get; set; }

    /// <summary>What was found of an entity in the image; not asked when nothing was.</summary>
    public OcclusionEstimate OcclusionOf(int handle) => _entities.TryGetValue(handle, out OcclusionEstimate found) ? found : default;

    /// <summary>Adds what was found of an entity or of one of its faces.</summary>
    /// <param name="found">The finding, for the scene.</param>
    /// <param name="estimate">The same as an estimate.</param>
    /// <param name="label">Its label; null when it is not listed.</param>
    /// <param name="region">Its ignore region; null for none.</param>
    public void Add(RecordedOcclusion found, OcclusionEstimate estimate, ObjectLabel? label, IgnoreRegion? region)
    {
        _occlusions.Add(found);
        if (found.Face is null)
        {
            _entities[found.Handle] = estimate;
        }

        List(label, region);
    }

    /// <summary>Adds what was found of an entity beyond the labelling range.</summary>
    public void Add(DistantEntity found, IgnoreRegion? region)
    {
        _distant.Add(found);
        List(null, region);
    }

    /// <summary>What labelling makes of it.</summary>
    /// <param name="ids">The numbers of the entities that have one, by handle.</param>
    /// <param name="rays">The rays that it took; null when that is not known.</param>
    public FrameLabelling Labelling(IReadOnlyDictionary<int, int> ids, RayCounts? rays) =>
        new([.. _objects.OrderBy(label => label.Id)], Mask)
        {
            PixelMap = PixelMap,
            Ids = ids,
            Occlusions = _occlusions,
            IgnoreRegions = [.. _regions.OrderBy(region => region.DistanceMetres)],
            Distant = _distant,
            Lanes = Lanes,
            Rays = rays,
        };

    private void List(ObjectLabel? label, IgnoreRegion? region)
    {
        if (label is not null)
        {
            _objects.Add(label);
        }

        if (region is not null)
        {
            _regions.Add(region);
        }
    }
}
