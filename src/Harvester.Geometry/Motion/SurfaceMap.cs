using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Motion;

/// <summary>The surfaces that a picture shows at the centres of its pixels.</summary>
public sealed class SurfaceMap
{
    /// <summary>Takes the surfaces of a picture, row by row.</summary>
    /// <param name="pose">The camera's pose in the world.</param>
    /// <param name="lines">The lines of sight of its pixels.</param>
    /// <param name="metres">
    /// Depth along the camera's axis, metres; positive infinity where nothing is seen, NaN where it is unknown. Not copied.
    /// </param>
    /// <param name="entities">Handle of the entity that is seen; 0 for the static world. Not copied.</param>
    /// <exception cref="ArgumentException">A list has not one entry for each pixel.</exception>
    public SurfaceMap(Pose pose, PixelLines lines, float[] metres, int[] entities)
    {
        Lines = Guard.NotNull(lines, nameof(lines));
        Camera = new Camera(pose, lines.Intrinsics);
        Metres = Guard.NotNull(metres, nameof(metres));
        Entities = Guard.NotNull(entities, nameof(entities));
        if (metres.Length != Camera.Image.PixelCount || entities.Length != Camera.Image.PixelCount)
        {
            throw new ArgumentException("There must be one depth and one entity for each pixel.", nameof(metres));
        }
    }

    /// <summary>The camera.</summary>
    public Camera Camera { get; }

    /// <summary>The lines of sight of its pixels.</summary>
    public PixelLines Lines { get; }

    /// <summary>Depth along the camera's axis, metres; positive infinity where nothing is seen, NaN where it is unknown.</summary>
    public float[] Metres { get; }

    /// <summary>Handle of the entity that is seen; 0 for the static world.</summary>
    public int[] Entities { get; }

    /// <summary>Estimated errors of the depths, metres; null for exact depths.</summary>
    public float[]? ErrorMetres { get; init; }
}
