using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Tests.Events;

/// <summary>What was true of the road users at a tick. The ego has the handle 0.</summary>
/// <param name="Seconds">The game's time, seconds.</param>
/// <param name="Bodies">The road users within 100 m of the ego, by handle.</param>
internal sealed record TrueMoment(double Seconds, IReadOnlyDictionary<int, TrueBody> Bodies)
{
    private const double Range = 100;

    public static TrueMoment Of(IWorld world)
    {
        EgoState ego = world.ReadEgo();
        var bodies = new Dictionary<int, TrueBody> { [0] = new(ObjectClass.Car, ego.Pose, ego.ModelMin, ego.ModelMax, ego.Velocity) };
        foreach (EntityState entity in world.ReadEntities(ego.Pose.Position, Range))
        {
            if (entity.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Rider))
            {
                bodies[entity.Handle] = new(entity.Class, entity.Pose, entity.ModelMin, entity.ModelMax, entity.Velocity);
            }
        }

        return new TrueMoment(world.TimeSeconds, bodies);
    }
}
