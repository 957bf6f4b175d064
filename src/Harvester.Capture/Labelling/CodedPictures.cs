using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Capture.Labelling;

/// <summary>The photographs from which the mask of a frame is decoded.</summary>
/// <param name="Targets">The objects that were hidden in turn. Their numbers are those of the frame's candidates, from 1.</param>
/// <param name="Plan">What the pictures show.</param>
/// <param name="Pictures">The pictures, three bytes a pixel; they may be used only until the frame is labelled.</param>
internal sealed record CodedPictures(IReadOnlyList<MapTarget> Targets, IPicturePlan Plan, IReadOnlyList<byte[]> Pictures);
