using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>Makes a frame's instance map by rays, a slice at a time.</summary>
internal interface IInstanceMapper
{
    /// <summary>Fills a map; after each slice the caller may leave off and go on later.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="boxes">Boxes in the image that hold all objects.</param>
    /// <param name="numberOf">The number in the map of an entity's handle; 0 for entities that are not labelled.</param>
    /// <param name="ignoredEntity">Handle of an entity that rays pass through.</param>
    /// <param name="rays">What rays meet.</param>
    /// <param name="map">The map to fill, empty before.</param>
    /// <returns>A sequence with one element a slice; its elements say nothing.</returns>
    IEnumerable<bool> Fill(
        Camera camera, IReadOnlyList<Box2D> boxes, Func<int, ushort> numberOf, int ignoredEntity, IRayCaster rays, InstanceMap map);
}
