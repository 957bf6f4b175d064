namespace Harvester.Simulation.Tests.Lanes;

/// <summary>What a picture shows where a marking is labelled.</summary>
internal enum PaintFindingKind
{
    /// <summary>Paint of the marking's colour and about its width.</summary>
    Paint,

    /// <summary>No paint of its colour is near.</summary>
    NoPaint,

    /// <summary>
    /// Something stands before it, or it is too thin in the picture, cut at a slant, or runs into other paint: its middle is unknown.
    /// </summary>
    NotMeasurable,
}
