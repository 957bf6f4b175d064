using Harvester.Geometry;

namespace Harvester.Sessions.Events;

/// <summary>Where two road users touched first, and how hard.</summary>
/// <param name="Position">Middle of what their footprints have in common, metres, world; halfway up the heights that both have.</param>
/// <param name="OnFirst">The same place from the middle of the first participant's footprint: to the right and forward, metres.</param>
/// <param name="OnSecond">The same for the second participant.</param>
/// <param name="RelativeSpeed">Length of the difference of the horizontal velocities just before, m/s; 0 or more.</param>
/// <param name="FirstSpeedChange">
/// Greatest change of the first participant's horizontal velocity in the 0.25 s from the contact, m/s; 0 or more.
/// </param>
/// <param name="SecondSpeedChange">The same of the second participant.</param>
/// <param name="Impulse">Estimated impulse, N·s: speed changes times usual masses of the classes; 0 or more.</param>
/// <param name="ImpulseMin">The impulse with the least masses that the classes have, N·s.</param>
/// <param name="ImpulseMax">The impulse with the greatest masses that the classes have, N·s.</param>
public sealed record EventContact(
    Vector3D Position,
    Vector2D OnFirst,
    Vector2D OnSecond,
    double RelativeSpeed,
    double FirstSpeedChange,
    double SecondSpeedChange,
    double Impulse,
    double ImpulseMin,
    double ImpulseMax
);
