using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Walking people: the variants are eight steps of a stride, the first with the legs together. As in the game, the origin is at the hips,
/// about a metre above the ground.
/// </summary>
internal static class PedestrianModels
{
    private const int Steps = 8;
    private static readonly Rgb[] Skins = [new(226, 182, 150), new(176, 124, 90), new(112, 76, 54)];

    public static IEnumerable<Model> All()
    {
        yield return Build("a_m_y_business_01", 1.84, 0, new(44, 50, 66), new(36, 40, 52));
        yield return Build("a_f_y_business_01", 1.70, 1, new(136, 40, 54), new(30, 30, 36));
        yield return Build("a_m_m_skater_01", 1.78, 0, new(198, 170, 60), new(62, 76, 104));
        yield return Build("a_f_y_fitness_01", 1.66, 0, new(60, 150, 150), new(34, 34, 40));
        yield return Build("a_m_y_downtown_01", 1.88, 2, new(210, 210, 206), new(84, 70, 56));
        yield return Build("a_f_m_tourist_01", 1.62, 1, new(230, 120, 96), new(190, 182, 160));
        yield return Build("a_m_o_genstreet_01", 1.73, 2, new(82, 104, 82), new(96, 92, 84));
    }

    private static Model Build(string name, double height, int skin, Rgb shirt, Rgb trousers) => Model.Of(
        name, ObjectClass.Pedestrian,
            Enumerable.Range(0, Steps).Select(step => BuildStep(height, Skins[skin], shirt, trousers, step)).ToArray());

    private static Mesh BuildStep(double height, Rgb skin, Rgb shirt, Rgb trousers, int step)
    {
        double swing = 0.42 * Math.Sin(2 * Math.PI * step / Steps);
        double hip = height * 0.5;
        double leg = hip - 0.07;
        double ground = -hip;
        var builder = new MeshBuilder();
        foreach (int side in new[] { -1, 1 })
        {
            // The foot that swings forward is raised so far that the leg keeps its length.
            var hipJoint = new Vector3D(side * 0.09, 0, 0);
            var ankle = new Vector3D(side * 0.09, side * Math.Sin(swing) * leg, -leg * Math.Cos(swing));
            builder.AddCylinder(hipJoint, ankle, 0.085, 0.055, 8, trousers);
            builder.AddBox(ankle + new Vector3D(-0.045, -0.08, -0.07), ankle + new Vector3D(0.045, 0.17, 0), new(34, 30, 30));
            var shoulder = new Vector3D(side * 0.2, 0, height * 0.32);
            double reach = height * 0.34;
            var hand = shoulder + new Vector3D(side * 0.05, -side * Math.Sin(swing * 0.8) * reach, -reach * Math.Cos(swing * 0.8));
            builder.AddCylinder(shoulder, hand, 0.055, 0.038, 7, shirt);
            builder.AddEllipsoid(hand, new(0.04, 0.05, 0.06), 6, 4, skin);
        }

        builder.AddFrustum(new(-0.16, -0.1, -0.04), new(0.16, 0.1, height * 0.34), new(-0.21, -0.11, 0), new(0.21, 0.11, 0), shirt);
        builder.AddCylinder(new(0, 0, height * 0.33), new(0, 0, height * 0.4), 0.05, 0.05, 8, skin);
        double crown = height + ground;
        builder.AddEllipsoid(new(0, 0.01, crown - 0.12), new(0.085, 0.1, 0.12), 10, 8, skin);
        builder.AddEllipsoid(new(0, -0.015, crown - 0.1), new(0.09, 0.1, 0.1), 10, 6, new(46, 34, 26));
        return builder.Build();
    }
}
