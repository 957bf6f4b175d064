namespace Harvester.Driving.Bridge;

/// <summary>Begins a new episode: the world is as after the start of the game with this seed, and its first frame is sent.</summary>
/// <param name="Seed">Seed of traffic, people, route and start; 0 or more.</param>
/// <param name="Town">Seed of the town; null for the game's own. Without effect on given roads.</param>
/// <param name="HasPicture">Whether the frame comes with an image.</param>
public sealed record RestartMessage(int Seed, int? Town = null, bool HasPicture = true) : ClientMessage;
