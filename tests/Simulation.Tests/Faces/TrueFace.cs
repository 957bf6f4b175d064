using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>What a picture truly shows of a face.</summary>
/// <param name="Centre">The centre of its cuboid, by which a label is assigned to it.</param>
/// <param name="FacesCamera">Whether the camera is before its plane.</param>
/// <param name="VisiblePixels">Pixels of the picture that show it.</param>
/// <param name="State">The lamp that burns; null for a sign.</param>
/// <param name="PixelsAlone">Pixels that would show it if there were nothing but its own model.</param>
internal sealed record TrueFace(Vector3D Centre, bool FacesCamera, int VisiblePixels, LightState? State, Lazy<int> PixelsAlone);
