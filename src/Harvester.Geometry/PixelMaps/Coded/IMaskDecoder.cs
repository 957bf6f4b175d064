namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>Decodes a mask from pictures, in steps, so that the work can be spread over ticks.</summary>
public interface IMaskDecoder
{
    /// <summary>Does a small part of the work.</summary>
    /// <returns>False if nothing is left to do.</returns>
    bool Step();

    /// <summary>Does what is left of the work and returns the result.</summary>
    CodedMask Finish();
}
