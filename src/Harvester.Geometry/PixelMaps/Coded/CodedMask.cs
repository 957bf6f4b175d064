namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>An instance map decoded from pictures.</summary>
/// <param name="Map">The targets' numbers, pixel by pixel.</param>
/// <param name="Undetermined">The pixels that change in a way that no object explains clearly; the map has 0 there.</param>
/// <param name="Amodal">
/// For each target's number, the pixels that it would have if no other target were in front of it. What is not a target still hides it.
/// </param>
public sealed record CodedMask(InstanceMap Map, PixelMap Undetermined, IReadOnlyDictionary<ushort, PixelMap> Amodal);
