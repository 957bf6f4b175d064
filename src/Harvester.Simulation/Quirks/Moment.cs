using System.Collections.Generic;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Quirks;

/// <summary>All that a picture of one state of the world is made from, and the truth about it.</summary>
/// <param name="State">Number of the state.</param>
/// <param name="Truth">Camera, ego and entities as they are, whatever the game reports.</param>
/// <param name="Moving">The shapes of what moves.</param>
/// <param name="Lighting">Light and weather.</param>
/// <param name="Lights">Lamps near the camera.</param>
internal sealed record Moment(
    long State, SceneSnapshot Truth, IReadOnlyList<MeshInstance> Moving, Lighting Lighting, IReadOnlyList<LightSource> Lights);
