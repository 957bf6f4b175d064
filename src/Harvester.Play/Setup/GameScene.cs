using Harvester.Capture.Ports;
using Harvester.Play.Features;

namespace Harvester.Play.Setup;

/// <summary>The readers of the scene around the mounted camera.</summary>
/// <param name="World">Reads it for labels.</param>
/// <param name="Props">Reads its props of any model.</param>
/// <param name="Sight">Reads single values of it for the overlay.</param>
public sealed record GameScene(IWorld World, IProps Props, ISightReader Sight);
