namespace Harvester.Cli.Commands.Roads;

/// <summary>What roads map writes.</summary>
internal enum RoadMapFormat
{
    /// <summary>A PNG image.</summary>
    Png,

    /// <summary>An SVG drawing.</summary>
    Svg,

    /// <summary>The lanes as ASAM OpenDRIVE.</summary>
    OpenDrive,

    /// <summary>The lanes as GeoJSON.</summary>
    GeoJson,
}
