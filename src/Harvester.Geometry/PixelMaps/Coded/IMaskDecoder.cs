using Harvester.Geometry.Work;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>Decodes a mask from pictures.</summary>
public interface IMaskDecoder
{
    /// <summary>The mask; null before the end of <see cref="Decode"/>.</summary>
    CodedMask? Mask { get; }

    /// <summary>Decodes the pictures, in small steps. Call it once.</summary>
    IEnumerable<WorkStep> Decode();
}
