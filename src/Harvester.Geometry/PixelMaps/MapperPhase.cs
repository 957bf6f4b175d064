namespace Harvester.Geometry.PixelMaps;

/// <summary>How far an adaptive map is.</summary>
internal enum MapperPhase
{
    /// <summary>A coarse grid and a few places in every silhouette.</summary>
    SeedSamples,

    /// <summary>Cells, the worst first.</summary>
    Cells,

    /// <summary>Probes of objects that no ray has met.</summary>
    Probes,

    /// <summary>Nothing left that the options ask for.</summary>
    Complete,
}
