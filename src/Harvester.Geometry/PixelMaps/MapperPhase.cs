namespace Harvester.Geometry.PixelMaps;

/// <summary>The phases of an adaptive map.</summary>
internal enum MapperPhase
{
    /// <summary>Samples a coarse grid and a few points in every silhouette.</summary>
    SeedSamples,

    /// <summary>Examines cells, the worst first.</summary>
    Cells,

    /// <summary>Probes objects that no ray has hit.</summary>
    Probes,

    /// <summary>Nothing that the options request is left to do.</summary>
    Complete,
}
